"""The testing data of section 6.1, in the readings that its text allows."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.atlas.check.degeneracy import find_degeneracy
from bodymeasure.atlas.check.finding import FindingKind
from bodymeasure.atlas.check.folds import fold_findings, normal_cones
from bodymeasure.errors import InputError
from bodymeasure.paper.data.self_intersection import intersects_itself

# "12 points at 6 possible heights", from that of the start to that of the end.
HEIGHTS = np.linspace(0.0, 1.0, 6)
# "a predetermined increment, say 0.0225"
INCREMENT = 0.0225
GROUPS = 4
GROUP_SIZE = 250
# A reading is given up after so many drawn patches for each that is wanted.
MOST_DRAWN = 200


@dataclass(frozen=True)
class Reading:
    """One way of reading section 6.1.

    Parameters
    ----------
    name, description : str
    side : float
        Side of the regular grid over which the control points stand.
    steps : int
        The most increments by which each control point is moved in x and in y; with 0, the grid
        stays regular.
    corners : bool
        Whether the two other corners have random heights, too. If not, they stand at half the
        height, and 12 points are left, as in the text.
    anywhere : bool
        Whether x and y are random multiples of the increment in the cube, in ascending order along
        u and along v, instead of near a grid.
    """

    name: str
    description: str
    side: float
    steps: int = 0
    corners: bool = True
    anywhere: bool = False


READINGS = (
    Reading(
        "grid 1",
        "Control points over a regular grid that fills the cube; all heights but those of the two "
        "ends drawn from six levels.",
        1.0,
    ),
    Reading(
        "grid 0.6",
        "As grid 1, over a grid of side 0.6: the shortest diagonals of the cube-wide grid exceed "
        "1.73, those of the paper's Table 3 lie between 1.37 and 1.60.",
        0.6,
    ),
    Reading(
        "twelve points",
        "Grid of side 0.6; the four corners fixed, at heights 0, 1/2, 1/2 and 1, so that 12 points "
        "have 6 possible heights, 72 choices, as the text says.",
        0.6,
        corners=False,
    ),
    Reading(
        "increments",
        "Grid of side 0.6, each control point but the ends moved in x and y by up to four "
        "increments of 0.0225.",
        0.6,
        steps=4,
    ),
    Reading(
        "anywhere",
        "x and y of all control points but the start drawn from the multiples of 0.0225 in the "
        "cube, and put in order along u and v.",
        1.0,
        anywhere=True,
    ),
)


@dataclass(frozen=True, eq=False)
class RandomPatches:
    """The accepted patches of one reading, and the numbers of refused ones.

    Parameters
    ----------
    control_points : ndarray, shape (groups, size, 4, 4, 3)
    folded, intersecting : int
        Patches that were drawn and refused because they fold over or cut through themselves.
    """

    control_points: Array
    folded: int
    intersecting: int


def make_testing_data(
    reading: Reading, seed: int, *, groups: int = GROUPS, size: int = GROUP_SIZE
) -> RandomPatches:
    """Return random patches as in section 6.1.

    Parameters
    ----------
    reading : Reading
    seed : int
        The same seed gives the same patches. Each group has its own random numbers.
    groups, size : int

    Raises
    ------
    InputError
        If too few of the patches drawn are sound.
    """
    accepted, folded, intersecting = [], 0, 0
    for group in range(groups):
        rng = np.random.default_rng([seed, READINGS.index(reading), group])
        patches: list[Array] = []
        drawn = 0
        while len(patches) < size:
            nets = draw(reading, rng, size - len(patches))
            drawn += len(nets)
            if drawn > MOST_DRAWN * size:
                raise InputError(
                    f"only {len(patches)} of {drawn} patches drawn for the reading "
                    f"{reading.name!r} are sound; choose another reading"
                )
            faults = [fault(net) for net in nets]
            folded += faults.count("folded")
            intersecting += faults.count("intersecting")
            patches += [net for net, f in zip(nets, faults, strict=True) if not f]
        accepted.append(np.array(patches))
    return RandomPatches(np.array(accepted), folded, intersecting)


def draw(reading: Reading, rng: np.random.Generator, count: int) -> Array:
    """Return patches of a reading, sound or not, shape (count, 4, 4, 3)."""
    height = HEIGHTS[rng.integers(0, len(HEIGHTS), (count, 4, 4))]
    height[:, 0, 0], height[:, 3, 3] = 0.0, 1.0
    if not reading.corners:
        height[:, 0, 3] = height[:, 3, 0] = 0.5
    if reading.anywhere:
        places = INCREMENT * rng.integers(0, int(1.0 / INCREMENT) + 1, (count, 4, 4, 2))
        places[:, 0, 0] = 0.0
        places = np.stack(
            [np.sort(places[..., 0], axis=1), np.sort(places[..., 1], axis=2)], axis=-1
        )
    else:
        line = np.linspace(0.0, reading.side, 4)
        grid = np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1)
        moves = rng.integers(-reading.steps, reading.steps + 1, (count, 4, 4, 2))
        moves[:, 0, 0] = moves[:, 3, 3] = 0
        places = grid + INCREMENT * moves
        # Control points stay within the cube.
        places = np.clip(places, 0.0, 1.0)
    return np.concatenate([places, height[..., None]], axis=-1)


def fault(net: Array) -> str:
    """Return ``folded``, ``intersecting``, or the empty string for a sound patch (4, 4, 3).

    A patch over a regular grid, and any patch whose projection onto its parameters is regular, is
    a graph, which has neither fault.
    """
    regular = np.diff(net[..., 0], axis=0) > 0.0, np.diff(net[..., 1], axis=1) > 0.0
    straight = np.ptp(net[..., 0], axis=1).max() == 0.0 and np.ptp(net[..., 1], axis=0).max() == 0.0
    if straight and regular[0].all() and regular[1].all():
        return ""
    if _is_folded(net):
        return "folded"
    return "intersecting" if intersects_itself(net) else ""


def _is_folded(net: Array) -> bool:
    atlas = Atlas(net.reshape(-1, 3), np.arange(16).reshape(1, 4, 4), Unit.M)
    cones = normal_cones(atlas.control_points)
    degeneracy = find_degeneracy(atlas.control_points, cones.largest)
    if degeneracy.patches.any() or degeneracy.edges.any():
        return True
    findings = fold_findings(atlas, cones, degeneracy)
    return any(finding.kind == FindingKind.FOLDED_PATCH for finding in findings)
