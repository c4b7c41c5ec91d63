"""What the viewer says about a patch that was picked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.atlas import Unit, convert_length

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

DIAGONALS = ("(0, 0) - (1, 1)", "(1, 0) - (0, 1)")


def describe(survey: Survey, patch: int, diagonal: int | None = None) -> str:
    """A patch's name and region, and the lengths of its diagonals in centimetres.

    Parameters
    ----------
    survey : Survey
    patch : int
    diagonal : int, optional
        Which of its diagonals was picked, 0 or 1; by default the patch as a whole.

    Returns
    -------
    str
        A few lines; only the picked diagonal, if there is one.
    """
    atlas = survey.atlas
    title = atlas.patch_names[patch]
    if atlas.regions[patch] and atlas.regions[patch] not in title:
        title += f" ({atlas.regions[patch]})"
    wanted = range(len(DIAGONALS)) if diagonal is None else (diagonal,)
    return "\n".join([title, *(_diagonal(survey, patch, number) for number in wanted)])


def _diagonal(survey: Survey, patch: int, diagonal: int) -> str:
    solution, check, unit = survey.diagonals, survey.cross_check, survey.atlas.unit
    length = float(solution.length[patch, diagonal])
    if not np.isfinite(length):
        status = solution.status[patch, diagonal]
        return f"{DIAGONALS[diagonal]}: no length; {getattr(status, 'value', status)}"
    text = f"{DIAGONALS[diagonal]}: {convert_length(length, unit, Unit.CM):.4f} cm"
    if check is not None and np.isfinite(check.relative_difference[patch, diagonal]):
        text += f", {check.relative_difference[patch, diagonal]:+.1e} from exact"
    return text
