"""The free legs of paths, each by a polynomial of the lowest degree that serves."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.contact.degrees import (
    LOWER_DEGREES,
    OVERSHOOT,
    degrees_wanted,
    leave_for_certain,
)
from bodymeasure.geodesic.contact.joined import SolvedLeg
from bodymeasure.geodesic.contact.legs import Ends
from bodymeasure.geodesic.contact.moving_ends import solve_with_moving_ends
from bodymeasure.geodesic.contact.tangency import tangency_errors
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface


class FreeLeg(NamedTuple):
    """A leg, and whether it stays in the patch."""

    solved: SolvedLeg
    inside: bool


def solve_free_legs(
    surface: Surface, polygons: Sequence[Array], ends: Sequence[Ends], tolerance: float
) -> list[FreeLeg | None]:
    """Solve for free legs by collocation, all at once; None for what has no solution.

    Parameters
    ----------
    surface : Surface
        The patch of each leg.
    polygons : sequence of ndarray, shape (k, 2)
        The parts of polygons that the legs stand for.
    ends : sequence of pairs of End
    tolerance : float
        The relative error of the length that is asked for.
    """
    found: list[FreeLeg | None] = [None] * len(polygons)
    times = [_times(surface.take(np.array([row])), each) for row, each in enumerate(polygons)]
    # A leg of no length has no solution.
    is_open = np.array([len(each) > 0 for each in times], bool)
    wanted = np.zeros(len(polygons))
    for degree in LOWER_DEGREES:
        rows = np.flatnonzero(is_open & (wanted <= degree)).tolist()
        if not rows:
            continue
        nodes = polynomial_space(degree).nodes
        guesses = [[np.interp(nodes, times[row], axis) for axis in polygons[row].T] for row in rows]
        known, degrees, done = _on_degree(
            degree,
            surface.take(np.array(rows)),
            np.array(guesses),
            [ends[row] for row in rows],
            tolerance,
        )
        wanted[rows], is_open[rows] = degrees, ~done
        for number, leg in known.items():
            found[rows[number]] = leg
    return found


def _times(surface: Surface, polygon: Array) -> Array:
    """The parts of its length at the vertices of a polygon; empty if it has none."""
    steps = np.diff(surface.jet(polygon[None], 0)[0, :, 0], axis=1)
    way = np.concatenate([[0.0], np.cumsum(np.sqrt((steps * steps).sum(axis=0)))])
    return way / way[-1] if way[-1] > 0.0 else way[:0]


def _on_degree(
    degree: int, surface: Surface, guesses: Array, ends: Sequence[Ends], tolerance: float
) -> tuple[dict[int, FreeLeg], Array, Bools]:
    """The legs known well enough, the degrees that seem to be wanted, and which legs are done."""
    space = polynomial_space(degree)
    values = solve_with_moving_ends(surface, space, guesses, ends)
    wanted, done = np.full(len(values), float(degree)), np.zeros(len(values), bool)
    rows: Ints = np.flatnonzero(np.isfinite(values).all(axis=(1, 2)))
    if len(rows) == 0:
        return {}, wanted, done
    surface, values = surface.take(rows), values[rows]
    length = measure_length(surface, space, values)
    # The error of a joint hardly depends on the degree.
    wanted[rows] = degrees_wanted(degree, length, tolerance)
    joints = tangency_errors(surface, space, values, [ends[row] for row in rows])
    length = replace(length, error=length.error + joints)
    known = length.is_known_to(tolerance)
    inside = ~space.leaves_patch(values, OVERSHOOT)
    done[rows] = known & (inside | leave_for_certain(space, values, length))
    legs = {
        int(rows[number]): FreeLeg(
            SolvedLeg(space, values[number], length.take(np.array([number]))), bool(inside[number])
        )
        for number in np.flatnonzero(known)
    }
    return legs, wanted, done
