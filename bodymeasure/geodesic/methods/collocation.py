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
        Makers of the trial spaces, in the order in which they are tried; called when needed.
    surface : Surface
    ends : tuple of ndarray
        Start and end, both of shape (problems, 2).
    tolerance : float
        Relative error of the length that is asked for.
    form : {"fast", "full"}
        Fast: first by `offset_form`, with one unknown function for a path, which serves Bezier
        patches and paths that run across their straight line; then, for those that are left, with
        two. Full: with two at once.
    """
    if form == "full" or not isinstance(surface, BezierSurfaces):
        return solve_on_spaces(spaces, surface, ends, tolerance=tolerance)
    found = solve_offsets(spaces, surface, ends, tolerance)
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
