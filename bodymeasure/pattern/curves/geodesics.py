"""Edges of pieces along geodesics."""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.geodesic import AtlasPath, geodesic_between
from bodymeasure.pattern.curves.skin_curve import Run, SkinCurve, on_sides, steps_of

# Chords of each piece by whose lengths places are found: a piece bends too little for them to
# differ from the arcs by more than a part in a million.
SAMPLES = 256


def geodesic_curve(atlas: Atlas, points: Sequence[AtlasPoint]) -> SkinCurve:
    """Return the shortest path through some points as a curve.

    Raises
    ------
    InputError
        If no seams join the points.
    ConvergenceError
        If its length cannot be trusted.
    """
    path = geodesic_between(atlas, points[0], points[-1], points[1:-1])
    return curve_of(path).with_ends(points[0], points[-1])


def curve_of(path: AtlasPath) -> SkinCurve:
    """Return a path as a curve on the skin."""
    meters = path.atlas.unit.meters
    runs = []
    for piece in path.pieces:
        if piece.length > 0.0:
            t = np.linspace(0.0, 1.0, steps_of(piece.length, meters) + 1)
            parameters = (piece.space.functions.values(t) @ piece.values.T).clip(0.0, 1.0)
            parameters[[0, -1]] = piece.values[:, [0, -1]].T
            runs.append(Run(piece.patch, on_sides(parameters)))

    # A piece along a side of its patch is not run at an even speed.
    sizes = np.array([piece.length for piece in path.pieces])
    bounds = np.concatenate([[0.0], np.cumsum(sizes)]) / sizes.sum()
    inner = np.arange(SAMPLES) / SAMPLES
    t = np.append((bounds[:-1, None] + np.diff(bounds)[:, None] * inner).ravel(), 1.0)
    t = np.unique(t)
    chords = np.linalg.norm(np.diff(path.position(t), axis=0), axis=1)
    run = np.concatenate([[0.0], np.cumsum(chords)])
    run *= path.length / run[-1]

    def places(arc: Array) -> tuple[Ints, Array]:
        return path.path(np.interp(arc, run, t))

    turns = np.interp(bounds[1:-1], t, run)
    return SkinCurve(path.length, tuple(runs), places, turns)
