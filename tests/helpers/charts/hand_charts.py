"""Charts whose tapes are made by hand from sections, their hulls, paths and straight lines."""

import itertools
from collections.abc import Sequence

import numpy as np
import scipy

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.normals import normal_vectors
from bodymeasure.chart import (
    Chart,
    Definitions,
    Measured,
    MeasurementDefinition,
    Outcome,
    Tape,
    TapeKind,
)
from bodymeasure.chart.kinds import (
    ChordMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    PathMeasure,
)
from bodymeasure.measure import Girth


def chart_of(atlas: Atlas, measured: Sequence[Measured]) -> Chart:
    """A chart of measurements made by hand; its landmarks are the atlas's."""
    definitions = Definitions(
        format="bodymeasure measurements",
        version=1,
        name="by hand",
        measurement=tuple(item.definition for item in measured),
    )
    return Chart(atlas, definitions, atlas.landmarks, {}, tuple(measured))


def girth_at(atlas: Atlas, landmark: str) -> Measured:
    """A horizontal girth, along the skin and taut."""
    definition = GirthMeasure(
        key=_key("girth", landmark), name=landmark, group="Girths", at=landmark
    )
    return _girth(atlas, definition, bm.body_girth(atlas, landmark), (landmark,))


def limb_girth_between(atlas: Atlas, start: str, end: str, at: float = 0.5) -> Measured:
    """A girth of a limb."""
    key = _key(f"limb_{at:.2f}", start).replace(".", "_")
    definition = LimbGirthMeasure(
        key=key, name=f"limb from {start}", group="Girths", start=start, end=end, at=at
    )
    girth = bm.limb_girth(atlas, start, end, at=at)
    return _girth(atlas, definition, girth, (start, end))


def path_between(atlas: Atlas, *through: str) -> Measured:
    """Shortest paths along the skin through landmarks."""
    definition = PathMeasure(
        key=_key("path", "_".join(through)),
        name=" to ".join(through),
        group="Lengths",
        through=through,
    )
    start, *via, end = (atlas.landmarks[name] for name in through)
    path = bm.geodesic_between(atlas, start, end, via)
    patch, parameters = path.path(np.linspace(0.0, 1.0, 200))
    normals = _normals(atlas, patch, parameters)
    tape = Tape(TapeKind.CONTACT, path.position(np.linspace(0.0, 1.0, 200)), normals)
    return _measured(definition, path.length, through, tape)


def chord_between(atlas: Atlas, start: str, end: str) -> Measured:
    """A straight distance."""
    definition = ChordMeasure(
        key=_key("chord", f"{start}_{end}"),
        name=f"{start}, {end}",
        group="Widths",
        start=start,
        end=end,
    )
    return _straight(definition, _place(atlas, start), _place(atlas, end), (start, end))


def height_of(atlas: Atlas, landmark: str) -> Measured:
    """A height above the lowest control point."""
    definition = HeightMeasure(
        key=_key("height", landmark), name=landmark, group="Heights", at=landmark
    )
    up, top = atlas.axes.up_vector, _place(atlas, landmark)
    floor = (atlas.points @ up).min()
    return _straight(definition, top, top + (floor - top @ up) * up, (landmark,))


def missing(key: str) -> Measured:
    """A measurement without a value."""
    definition = HeightMeasure(key=key, name=key, group="Heights", at="cervicale")
    return Measured(definition, Outcome.MISSING_LANDMARK, reason="no landmark cervicale")


def _measured(
    definition: MeasurementDefinition, value: float, landmarks: tuple[str, ...], *tapes: Tape
) -> Measured:
    return Measured(
        definition, Outcome.MEASURED, value=value, contact=value, landmarks=landmarks, tapes=tapes
    )


def _girth(
    atlas: Atlas, definition: MeasurementDefinition, girth: Girth, landmarks: tuple[str, ...]
) -> Measured:
    loop = girth.loop
    normals = _normals(atlas, loop.patch, loop.parameters)
    points = np.concatenate([loop.positions, loop.positions[:1]])
    normals = np.concatenate([normals, normals[:1]])
    contact = Tape(TapeKind.CONTACT, points, normals)
    return _measured(definition, girth.taut, landmarks, contact, _taut(contact))


def _taut(contact: Tape) -> Tape:
    """The hull of a flat loop, its bridges free."""
    _, _, axes = np.linalg.svd(contact.points - contact.points.mean(axis=0), full_matrices=False)
    corner = np.sort(scipy.spatial.ConvexHull(contact.points[:-1] @ axes[:2].T).vertices)
    corner = np.append(corner, corner[0])
    points, normals = [], []
    for first, last in itertools.pairwise(corner):
        points.append(contact.points[first])
        normals.append(contact.normals[first])
        if (last - first) % (len(contact.points) - 1) > 1:
            # Free from just behind where the tape leaves the skin.
            share = np.array([[0.01], [0.99]])
            points += list(contact.points[first] * (1 - share) + contact.points[last] * share)
            normals += [np.zeros(3), np.zeros(3)]
    points.append(points[0])
    normals.append(normals[0])
    return Tape(TapeKind.TAUT, np.array(points), np.array(normals))


def _straight(
    definition: MeasurementDefinition,
    start: Array,
    end: Array,
    landmarks: tuple[str, ...],
) -> Measured:
    points = np.stack([start, end])
    tape = Tape(TapeKind.STRAIGHT, points, np.zeros((2, 3)))
    return _measured(definition, float(np.linalg.norm(end - start)), landmarks, tape)


def _place(atlas: Atlas, landmark: str) -> Array:
    return atlas.position(atlas.landmarks[landmark])


def _normals(atlas: Atlas, patch: Ints, parameters: Array) -> Array:
    normals = normal_vectors(atlas.control_points[patch], parameters)
    return np.asarray(normals / np.linalg.norm(normals, axis=-1, keepdims=True))


def _key(kind: str, name: str) -> str:
    return f"{kind}_{name}".replace(" ", "_")
