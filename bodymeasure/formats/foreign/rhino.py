"""Rhino's files, ``.3dm``: NURBS surfaces, and the faces of polysurfaces, cut into Bezier patches.

Read by rhino3dm (extra ``rhino``) in a process of its own, since a single wrong byte may make it
ask for gigabytes. The unit is the file's; names of objects and layers become those of patches and
regions.
"""

from dataclasses import replace
from importlib.util import find_spec

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.formats.foreign.process import Reader, surfaces_of_file
from bodymeasure.formats.patches import ReadPatches

UNITS = {
    "Millimeters": Unit.MM,
    "Centimeters": Unit.CM,
    "Meters": Unit.M,
    "Inches": Unit.INCH,
}
# What stands in place of the unit in a file that has none.
NO_UNIT = ("None", "Unset")
READER = Reader("rhino_worker.py", "3dm", "3dm", "rhino3dm", 60.0)


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    if find_spec("rhino3dm") is None:
        raise MissingExtraError(f"reading {source}", "rhino3dm", "rhino")
    unit, patches = surfaces_of_file(content, source, READER)
    return replace(patches, unit=_unit(unit, source))


def _unit(name: str, source: str) -> Unit | None:
    if name in NO_UNIT:
        return None
    if name not in UNITS:
        raise InputError(
            f"{source}: is in {name}; expected one of {', '.join(UNITS)}: change the unit in Rhino"
        )
    return UNITS[name]
