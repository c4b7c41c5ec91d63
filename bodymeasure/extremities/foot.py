"""The measurements of a foot."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.extremities.places import FEET, places
from bodymeasure.extremities.surface import Length, Patchwork, farthest, girth, patchworks
from bodymeasure.subdivision import QuadMesh, quads_within

# Where the instep is taken, as a part of the foot's length from the heel.
INSTEP = 0.5
# Rings of quads of the leg above a foot, over which the tape round heel and ankle runs.
ABOVE = 4


class _Frame(NamedTuple):
    """The directions of a foot: along it to the toes, across it, and square to its sole."""

    along: Array
    across: Array
    up: Array


def foot_lengths(whole: QuadMesh, limit: Array, side: str) -> dict[str, Length]:
    """Return the lengths of a foot, by the keys of the default set without their side.

    Parameters
    ----------
    whole : QuadMesh
    limit : ndarray, shape (13380, 3)
        The limits of its vertices.
    side : {"left", "right"}

    Notes
    -----
    The sole's plane is that of heel and both balls, so that a foot that does not stand flat is
    measured as one that does. The foot's length runs along the line from the heel to the second
    toe.
    """
    number = list(FEET).index(side)
    at = {name: limit[pair[number]] for name, pair in places().landmarks.items()}
    region = np.isin(places().region, FEET[side])
    steps = patchworks(whole, region)
    frame = _frame(at)
    heel, to_heel = farthest(steps, lambda points: -points @ frame.along)
    _, to_toe = farthest(steps, lambda points: points @ frame.along)
    length = to_heel.value + to_toe.value
    one, to_one = farthest(steps, lambda points: points @ frame.across)
    other, to_other = farthest(steps, lambda points: -points @ frame.across)
    ball = _square(np.cross(one - other, frame.up))
    middle = heel + INSTEP * length * frame.along
    with_leg = np.zeros(len(limit), dtype=np.bool_)
    with_leg[np.unique(whole.quads[quads_within(whole, region, ABOVE)])] = True
    crease, under = at["instep crease"], at["heel bottom back"]
    return {
        "foot_length": Length(length, to_heel.error + to_toe.error),
        "foot_breadth": Length(to_one.value + to_other.value, to_one.error + to_other.error),
        "foot_girth": girth(steps, one, ball),
        "instep_girth": girth(steps, middle, frame.along),
        "heel_girth": _slanting(patchworks(whole, with_leg), (crease, under), frame.across),
    }


def _frame(at: dict[str, Array]) -> _Frame:
    heel, inner, outer = (
        at[f"foot sole {place}"] for place in ("heel", "ball inner", "ball outer")
    )
    up = _square(np.cross(inner - heel, outer - heel))
    up *= np.sign(up @ (at["instep crease"] - heel))
    along = at["second toe tip"] - at["heel back"]
    along = _square(along - (along @ up) * up)
    return _Frame(along, np.cross(up, along), up)


def _slanting(steps: Sequence[Patchwork], through: tuple[Array, Array], across: Array) -> Length:
    one, other = through
    return girth(steps, one, _square(np.cross(other - one, across)))


def _square(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))
