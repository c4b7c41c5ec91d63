"""STEP and IGES files: B-spline surfaces, and the faces of solids, cut into Bezier patches.

Read by Open CASCADE (extra ``cad``) in a process of its own, which a broken file may end without
harm. Coordinates are in millimeters, whatever the file is in: Open CASCADE converts them.
"""

from dataclasses import replace
from functools import partial
from importlib.util import find_spec

from bodymeasure.atlas import Unit
from bodymeasure.errors import MissingExtraError
from bodymeasure.formats.foreign.process import Reader, surfaces_of_file
from bodymeasure.formats.patches import ReadPatches

# The time limit in seconds; Open CASCADE needs one or two to start.
LONGEST = 60.0


def _read(content: bytes, source: str, *, kind: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    if find_spec("OCP") is None:
        raise MissingExtraError(f"reading {source}", "cadquery-ocp-novtk", "cad")
    reader = Reader("cad_worker.py", kind, kind.upper(), "Open CASCADE", LONGEST)
    _, patches = surfaces_of_file(content, source, reader)
    return replace(patches, unit=Unit.MM)


read_step = partial(_read, kind="step")
read_iges = partial(_read, kind="iges")
