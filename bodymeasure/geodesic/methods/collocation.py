"""Collocation on trial spaces in turn, with one unknown function where that serves, else two."""

from collections.abc import Callable, Sequence
from typing import Literal, get_args

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.graph.solve import solve_offsets
from bodymeasure.geodesic.solving.on_spaces import solve_on_spaces
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import Surface

Form = Literal["fast", "full"]
FORMS: tuple[Form, ...] = get_args(Form)


def check_form(form: str) -> None:
    """Raise an InputError unless there is such a form of the equations."""
    if form not in FORMS:
        raise InputError(f"form is {form!r}; expected one of {', '.join(FORMS)}")


def collocate(
    spaces: Sequence[Callable[[], TrialSpace]],
    surface: Surface,
    ends: tuple[Array, Array],
    *,
    tolerance: float,
    form: Form,
) -> MethodResult:
    """Solve a batch of problems on trial spaces in turn.

    Parameters
    ----------
    spaces : sequence of callable
        Functions that make the trial spaces when they are needed, in the order of their use.
    surface : Surface
    ends : tuple of ndarray
        The starts and the ends, both of shape (problems, 2).
    tolerance : float
        The relative error of the length that is asked for.
    form : {"fast", "full"}
        "fast" first solves with one unknown function for a path, as in `graph.solve`, which serves
        Bezier patches and paths that are graphs over their straight line, and then with two for
        those that are left; "full" solves with two at once.
    """
    if form == "full" or not isinstance(surface, BezierSurfaces):
        return solve_on_spaces(spaces, surface, ends, tolerance=tolerance)
    found = solve_offsets(spaces, surface, ends, tolerance)
    if sum(len(batch.problems) for batch in found.batches) == len(ends[0]):
        return found
    is_open = np.ones(len(ends[0]), bool)
    for batch in found.batches:
        is_open[batch.problems] = False
    rest = np.flatnonzero(is_open)
    others = solve_on_spaces(
        spaces, surface.take(rest), (ends[0][rest], ends[1][rest]), tolerance=tolerance
    )
    iterations = found.iterations.copy()
    iterations[rest] += others.iterations
    batches = [batch.renumbered(rest[batch.problems]) for batch in others.batches]
    return MethodResult((*found.batches, *batches), iterations)
