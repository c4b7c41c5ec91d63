"""What a user gives to be shown: a body, a file, or what was measured on a body."""

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.errors import InputError
from bodymeasure.formats import read_atlas

if TYPE_CHECKING:
    from bodymeasure.chart import Chart
    from bodymeasure.measure import Survey

EXPECTED = "an Atlas, a Chart, a Survey, or the name of a file"


class Given(NamedTuple):
    """A body to be shown, and what was measured on it."""

    body: ShownBody
    chart: "Chart | None" = None
    survey: "Survey | None" = None


def given(shown: Any, unit: Unit | str | None = None) -> Given:
    """Return what is to be shown.

    Parameters
    ----------
    shown : Atlas, Chart, Survey, str or Path
    unit : Unit or str, optional
        Unit of a file's coordinates, for formats that state none.

    Raises
    ------
    InputError
        If it is nothing of these, or the file cannot be read.
    """
    if isinstance(shown, str | Path):
        read = read_atlas(shown, unit=unit)
        # Landmarks can be saved into a file that can be read in the same way again.
        settings = {"unit": unit}
        name = read.name or Path(shown).stem
        return Given(ShownBody("0", read, name, str(shown), settings=settings))
    if unit is not None:
        raise InputError(
            f"unit is {unit!r}, but it is the unit of a file's coordinates, and no name of a file "
            "is given"
        )
    atlas: Any = shown if isinstance(shown, Atlas) else getattr(shown, "atlas", None)
    if not isinstance(atlas, Atlas):
        raise InputError(f"there is nothing to show in {shown!r}; expected {EXPECTED}")
    body = ShownBody("0", atlas, atlas.name)
    if hasattr(shown, "measured"):
        return Given(body, chart=shown)
    if hasattr(shown, "diagonals"):
        return Given(body, survey=shown)
    return Given(body)
