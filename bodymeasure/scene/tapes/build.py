"""Build the scene that the pictures of a chart show."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart import Chart, Measured, Tape
from bodymeasure.scene.diagonals.build import BODY_SEGMENTS, tessellate
from bodymeasure.scene.model import Label, TapeLine, TapeScene, free_of_body
from bodymeasure.scene.tapes.mesh import tape_tube

# Distance of the points along a drawn tape, as a fraction of the body's size: on a mannequin 5 mm,
# so that round an ankle the polygon stays within a tenth of a millimeter of the curve.
SPACING = 1.0 / 300.0
# How often the directions in which tapes are lifted are mixed with their neighbors: over some 2 cm.
SMOOTHINGS = 8
# The size of a flat atlas, which has no height, as a fraction of its extent.
LEAST_SIZE = 0.25


def tapes_scene(chart: Chart) -> TapeScene:
    """Build the scene of a body with all tapes of a chart.

    Parameters
    ----------
    chart : Chart

    Returns
    -------
    TapeScene
        Measurements with a value, even without a tape, are numbered from 1 in the order of the
        chart.
    """
    atlas = chart.atlas
    surface = tessellate(atlas, np.arange(len(atlas)), BODY_SEGMENTS)
    extent = np.ptp(surface.points, axis=0).max()
    size = max(float(np.ptp(surface.points @ atlas.axes.up_vector)), LEAST_SIZE * float(extent))
    having = [item for item in chart.measured if np.isfinite(item.value)]
    numbers = {item.definition.key: number for number, item in enumerate(having, start=1)}
    lines = [
        _line(item, tape, numbers[item.definition.key], SPACING * size)
        for item in having
        for tape in item.tapes
        if len(tape.points) > 1
    ]
    landmarks = {item.definition.key: _landmarks(chart, item) for item in having}
    return TapeScene(surface, size, numbers, tuple(lines), landmarks)


def _line(item: Measured, tape: Tape, number: int, spacing: float) -> TapeLine:
    lift = without_gaps(tape.points, tape.normals)
    values = np.concatenate([tape.normals, lift], axis=1)
    points, values = evenly_spaced(tape.points, values, spacing)
    normals, lift = values[:, :3], smoothed(values[:, 3:])
    tube = tape_tube(points, lift, free_of_body(normals), tape.kind)
    definition = item.definition
    return TapeLine(
        number, definition.key, definition.group, tape.kind, points, normals, lift, tube
    )


def _landmarks(chart: Chart, item: Measured) -> tuple[Label, ...]:
    found = [name for name in item.landmarks if name in chart.landmarks]
    return tuple(Label(chart.atlas.position(chart.landmarks[name]), name) for name in found)


def evenly_spaced(points: Array, values: Array, spacing: float) -> tuple[Array, Array]:
    """Sample a polygon and values along it at even distances.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
    values : ndarray, shape (k, c)
    spacing : float
        The largest distance between two neighboring new points along the polygon.

    Returns
    -------
    points : ndarray, shape (m, 3)
        At least two; the first and the last point of the polygon are kept.
    values : ndarray, shape (m, c)
    """
    along = arc_length(points)
    count = max(2, int(np.ceil(along[-1] / spacing)) + 1)
    place = np.linspace(0.0, along[-1], count)
    every = np.concatenate([points, values], axis=1).T
    new = np.stack([np.interp(place, along, value) for value in every], axis=1)
    return new[:, :3], new[:, 3:]


def without_gaps(points: Array, normals: Array) -> Array:
    """Interpolate the normals along a polygon, (k, 3), where they are 0."""
    given = normals.any(axis=1)
    if not given.any():
        return normals
    along = arc_length(points)
    columns = [np.interp(along, along[given], column[given]) for column in normals.T]
    filled = np.stack(columns, axis=1)
    length = np.linalg.norm(filled, axis=1, keepdims=True)
    # Normals that are opposite cancel half-way.
    return np.asarray(np.divide(filled, length, out=filled, where=length > 0.0))


def smoothed(vectors: Array) -> Array:
    """Mix each vector along a curve, (k, 3), with its neighbors, and keep its length.

    Along a seam where patches meet in a slight kink, the normals alternate between the patches.
    """
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    mixed = vectors
    for _ in range(SMOOTHINGS):
        around = np.concatenate([mixed[:1], mixed, mixed[-1:]])
        mixed = (around[:-2] + 2.0 * around[1:-1] + around[2:]) / 4.0
    size = np.linalg.norm(mixed, axis=1, keepdims=True)
    mixed = np.divide(mixed, size, out=np.zeros_like(mixed), where=size > 0.0)
    return np.asarray(length * mixed)


def arc_length(points: Array) -> Array:
    """Return the length of a polygon up to each of its points, shape (k,)."""
    step = np.linalg.norm(np.diff(points, axis=0), axis=-1)
    return np.concatenate([np.zeros(1), np.cumsum(step)])
