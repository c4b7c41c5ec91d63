"""Derivatives of landmarks on the geodesic between two others."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.chart.body import Body
from bodymeasure.chart.landmarks.paths import leg_between
from bodymeasure.chart.landmarks.rules.at_height import AtHeight
from bodymeasure.chart.landmarks.rules.between import Between
from bodymeasure.chart.landmarks.rules.hollow import Hollow
from bodymeasure.geodesic import AtlasPath
from bodymeasure.make.gradient.chain import bends
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.way import Way, Weigh, pull_way, way_to

# Nodes to either side of a hollow's deepest place, every other one, whose distances from the chord
# give their derivatives.
REACH = 4


def pull_between(
    pull: Pull, body: Body, rule: Between, vector: Array, fraction: float | None = None
) -> None:
    """Add the derivatives of a place at a fraction of a geodesic's length."""
    way, names = _way(body, rule)
    _pull_fraction(pull, way, names, vector, rule.fraction if fraction is None else fraction)


def pull_at_height(pull: Pull, body: Body, rule: AtHeight, vector: Array) -> None:
    """Add the derivatives of a place where a geodesic passes a height."""
    way, names = _way(body, rule)
    up = body.atlas.axes.up_vector
    slide = float(vector @ way.tangent) / float(up @ way.tangent)
    pull.at(rule.of, slide * up)
    pull_way(pull, way, _at_point(vector - slide * up), names)


def pull_hollow(pull: Pull, body: Body, rule: Hollow, vector: Array) -> None:
    """Add the derivatives of the deepest place of a hollow below the chord of a geodesic."""
    way, names = _way(body, rule)
    if rule.otherwise is not None and _is_fraction(way, rule.otherwise):
        _pull_fraction(pull, way, names, vector, rule.otherwise)
        return
    start, end = (body.position(name) for name in (rule.start, rule.end))
    length = float(np.linalg.norm(end - start))
    axis = (end - start) / length
    rows = _beside(way)
    if len(rows) < 3:
        # At the end of a piece, where the path has a kink, the deepest place stays.
        pull_way(pull, way, _at_point(vector), names)
        return
    first, second = _differences(way.time[rows] - way.time[way.node])
    from_start = way.positions[rows] - start
    along = from_start @ axis
    offset = from_start - along[:, None] * axis
    # The slope of the squared distance from the chord is 0 at the place, which slides to stay so.
    curved = float(second @ (offset**2).sum(axis=1))
    slide = -float(vector @ way.velocity[way.node]) / curved
    moved = 2.0 * slide * first[:, None] * offset
    pull.at(rule.start, -((1.0 - along / length)[:, None] * moved).sum(axis=0))
    pull.at(rule.end, -((along / length)[:, None] * moved).sum(axis=0))

    def weigh(positions: Array, node: int) -> Array:
        weights = np.zeros_like(positions)
        weights[node] = vector
        # The rows are every other node, which both chains have.
        places = node + (rows - way.node) // (1 if len(positions) == len(way.patch) else 2)
        weights[places] += moved
        return weights

    pull_way(pull, way, weigh, names)


def _at_point(vector: Array) -> Weigh:
    def weigh(positions: Array, node: int) -> Array:
        weights = np.zeros_like(positions)
        weights[node] = vector
        return weights

    return weigh


def _beside(way: Way) -> Ints:
    """Return every other node about the point on its own piece, the point among them."""
    rows = way.node + 2 * np.arange(-REACH, REACH + 1)
    rows = rows[(rows >= 0) & (rows < len(way.patch))]
    rows = rows[way.piece[rows] == way.piece[way.node]]
    inside = 0.0 < way.time[way.node] < 1.0
    return np.asarray(rows if inside else rows[:0])


def _differences(times: Array) -> tuple[Array, Array]:
    """Return the weights of values at some times for the first two derivatives at 0."""
    scale = float(np.abs(times).max())
    powers = np.vander(times / scale, increasing=True).T
    wanted = np.zeros((len(times), 2))
    wanted[1, 0], wanted[2, 1] = 1.0 / scale, 2.0 / scale**2
    first, second = np.linalg.solve(powers, wanted).T
    return first, second


def _way(body: Body, rule: Between | AtHeight | Hollow) -> tuple[Way, tuple[str, str]]:
    path = leg_between(body.atlas, body.point(rule.start), body.point(rule.end))
    number, fraction = _place_on(path, body.point(rule.name))
    return way_to(path, number, fraction), (rule.start, rule.end)


def _place_on(path: AtlasPath, point: AtlasPoint) -> tuple[int, float]:
    """Return the piece of a path and the fraction of it at which a point of the path lies."""
    position = path.atlas.position(point)
    best = (np.inf, 0, 0.0)
    times = np.arange(65) / 64.0
    for number, piece in enumerate(path.pieces):
        if piece.length == 0.0:
            continue
        grid = times
        apart = np.empty(0)
        for _ in range(10):
            places = np.clip(piece.space.functions.values(grid) @ piece.values.T, 0.0, 1.0)
            patch = np.full(len(grid), piece.patch)
            positions = _positions(path, patch, places)
            apart = np.linalg.norm(positions - position, axis=1)
            nearest = int(apart.argmin())
            width = grid[1] - grid[0]
            if width < 1e-13:
                break
            low, high = max(grid[nearest] - width, 0.0), min(grid[nearest] + width, 1.0)
            closest = float(grid[nearest])
            grid = np.linspace(low, high, 65)
        if apart.min() < best[0]:
            best = (float(apart.min()), number, closest)
    return best[1], best[2]


def _positions(path: AtlasPath, patch: Ints, places: Array) -> Array:
    return evaluate(path.atlas.control_points[patch], places[:, None])[:, 0]


def _is_fraction(way: Way, fraction: float) -> bool:
    sizes = np.linalg.norm(np.diff(way.positions, axis=0), axis=1)
    return bool(abs(sizes[: way.node].sum() / sizes.sum() - fraction) < 1e-7)


def _pull_fraction(
    pull: Pull, way: Way, names: tuple[str, str], vector: Array, fraction: float
) -> None:
    """Add the derivatives of a place that slides until it divides a way in a ratio."""
    along = float(vector @ way.tangent)

    def weigh(positions: Array, node: int) -> Array:
        before = np.zeros_like(positions)
        before[: node + 1] = bends(positions[: node + 1])
        weights = along * (fraction * bends(positions) - before)
        weights[node] += vector
        return np.asarray(weights)

    pull_way(pull, way, weigh, names)
