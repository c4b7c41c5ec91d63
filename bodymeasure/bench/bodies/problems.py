"""What is measured on a body: paths, girths, loops and tapes, drawn by number."""

from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bench.problems.sets import SEED
from bodymeasure.section import Plane

# A place on every mesh whose edges have a multiple of four segments.
QUARTERS = 4
# Girths are taken in level planes between the first two places, and square to the others' lines.
TRUNK = (
    ("side hip point left", "side waist point left"),
    ("side waist point left", "bust point left"),
)
LIMBS = ("shoulder point left", "elbow point left"), ("patella point left", "side hip point left")
# The parts of each stretch in which planes lie: farther on, an arm or a leg is not alone.
WITHIN_TRUNK, WITHIN_LIMBS = (0.1, 0.9), (0.3, 0.7)
# Loops slide from the heights of these places to the natural waist, to the knee, and to the neck.
LOOP_PLACES = (
    "side waist point left",
    "patella point left",
    "front neck point",
    "bust point left",
    "side hip point left",
)


class Ring(NamedTuple):
    """A plane that cuts a body, and the place beside which the loop lies that is measured."""

    plane: Plane
    place: Array
    limb: bool


Item = tuple[AtlasPoint, AtlasPoint] | Ring | str | tuple[str, str] | None
"""Two ends of a path, a girth, the place of a loop, two landmarks of a tape; None for a chart."""


@dataclass(frozen=True, eq=False)
class BodyProblems:
    """What is measured on a body.

    Parameters
    ----------
    atlas : Atlas
    items : tuple of Item
        All of one kind.
    """

    atlas: Atlas
    items: tuple[Item, ...]

    def take(self, rows: Ints | slice) -> "BodyProblems":
        """Return some of the problems."""
        chosen = np.arange(len(self.items))[rows].tolist()
        return BodyProblems(self.atlas, tuple(self.items[number] for number in chosen))


def ends_of_paths(atlas: Atlas, count: int) -> tuple[Item, ...]:
    """Return random pairs of points, which are vertices of every mesh."""
    rng = np.random.default_rng(SEED)

    def point() -> AtlasPoint:
        u, v = (rng.integers(1, QUARTERS, 2) / QUARTERS).tolist()
        return AtlasPoint(int(rng.integers(len(atlas))), u, v)

    return tuple((point(), point()) for _ in range(count))


def rings(atlas: Atlas, count: int) -> tuple[Item, ...]:
    """Return planes at even distances along trunk, arm and leg, in random order."""
    stretches = [(ends, False) for ends in TRUNK] + [(ends, True) for ends in LIMBS]
    found = []
    for number, (names, limb) in enumerate(stretches):
        first, last = (atlas.position(atlas.landmarks[name]) for name in names)
        parts = np.linspace(
            *(WITHIN_LIMBS if limb else WITHIN_TRUNK), len(range(number, count, len(stretches)))
        )
        for part in parts:
            place = first + part * (last - first)
            normal = last - first if limb else atlas.axes.up_vector
            found.append(Ring(Plane(place, normal), place, limb))
    order = np.random.default_rng(SEED).permutation(len(found)).tolist()
    return tuple(found[number] for number in order)


def loop_places(_atlas: Atlas, count: int) -> tuple[Item, ...]:
    """Return places at whose heights loops begin, of which there are few."""
    return LOOP_PLACES[:count]


def ends_of_tapes(atlas: Atlas, count: int) -> tuple[Item, ...]:
    """Return random pairs of landmarks."""
    pairs = list(combinations(atlas.landmarks, 2))
    order = np.random.default_rng(SEED).permutation(len(pairs))[:count].tolist()
    return tuple(pairs[number] for number in order)


def one_chart(_atlas: Atlas, _count: int) -> tuple[Item, ...]:
    """Return the one chart of a body."""
    return (None,)
