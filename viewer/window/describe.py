"""The words that the viewer shows about a patch or a tape that was picked."""

from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.atlas import Unit, convert_length

if TYPE_CHECKING:
    from bodymeasure.chart import Measured
    from bodymeasure.measure import Survey

DIAGONALS = ("(0, 0) - (1, 1)", "(1, 0) - (0, 1)")


def describe(survey: "Survey", patch: int, diagonal: int | None = None) -> str:
    """Describe a patch by its name, its region, and the lengths of its diagonals in centimeters.

    Parameters
    ----------
    survey : Survey
    patch : int
    diagonal : int, optional
        Which of its diagonals was picked, 0 or 1; by default the patch as a whole.

    Returns
    -------
    str
        A few lines; of the diagonals only the picked one, if one was picked.
    """
    atlas = survey.atlas
    title = atlas.patch_names[patch]
    if atlas.regions[patch] and atlas.regions[patch] not in title:
        title += f" ({atlas.regions[patch]})"
    wanted = range(len(DIAGONALS)) if diagonal is None else (diagonal,)
    return "\n".join([title, *(_diagonal(survey, patch, number) for number in wanted)])


def _diagonal(survey: "Survey", patch: int, diagonal: int) -> str:
    solution, check, unit = survey.diagonals, survey.cross_check, survey.atlas.unit
    length = float(solution.length[patch, diagonal])
    if not np.isfinite(length):
        status = np.asarray(solution.status)[patch, diagonal]
        return f"{DIAGONALS[diagonal]}: no length; {getattr(status, 'value', status)}"
    text = f"{DIAGONALS[diagonal]}: {convert_length(length, unit, Unit.CM):.4f} cm"
    if check is not None and np.isfinite(check.relative_difference[patch, diagonal]):
        text += f", {check.relative_difference[patch, diagonal]:+.1e} from exact"
    return text


def describe_measured(item: "Measured", unit: Unit) -> str:
    """Describe a measurement by its name, its value in centimeters, and how the tape lies.

    Parameters
    ----------
    item : Measured
    unit : Unit
        Unit of its lengths.

    Returns
    -------
    str
        A few lines: name and key, value, lengths along the skin and taut if there are both, and
        a remark.
    """
    definition = item.definition
    lines = [f"{definition.name} ({definition.key})"]
    if np.isfinite(item.value):
        lines.append(
            f"{item.value:.2f} degrees" if definition.in_degrees else _centimeters(item.value, unit)
        )
        if np.isfinite(item.contact) and np.isfinite(item.taut):
            skin, taut = _centimeters(item.contact, unit), _centimeters(item.taut, unit)
            lines.append(f"along the skin {skin}, taut {taut}")
    if item.reason:
        lines.append(item.reason)
    return "\n".join(lines)


def _centimeters(length: float, unit: Unit) -> str:
    return f"{convert_length(length, unit, Unit.CM):.2f} cm"
