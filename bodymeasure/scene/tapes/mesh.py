"""Tapes as colored tubes: how contact, taut and straight ones look."""

from collections.abc import Mapping, Sequence
from functools import cache

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.chart import TapeKind
from bodymeasure.mesh.tubes import Mesh, ball, joined, tube
from bodymeasure.scene.camera import View
from bodymeasure.scene.model import TapeLine, TapeScene, TapeTube

# Okabe and Ito's blue and vermilion, which color-blind readers can distinguish, and nearly black.
COLORS: Mapping[TapeKind, tuple[float, float, float]] = {
    TapeKind.CONTACT: (0.0, 0.40, 0.72),
    TapeKind.TAUT: (0.88, 0.38, 0.0),
    TapeKind.STRAIGHT: (0.16, 0.16, 0.20),
}
# Color of the bands of a taut tape where it stands free of the body, and their length in points.
BAND = (1.0, 0.93, 0.72)
BAND_POINTS = 3
# Radii as fractions of a contact tape's. Where both lie on the skin, the taut one runs along the
# back of the other, and both are seen.
THICKNESS: Mapping[TapeKind, float] = {
    TapeKind.CONTACT: 1.0,
    TapeKind.TAUT: 0.62,
    TapeKind.STRAIGHT: 0.6,
}
# Height of the middle of a tube above the skin, in a contact tape's radii: enough that no tube
# sinks into the skin's tessellation.
LIFT: Mapping[TapeKind, float] = {TapeKind.CONTACT: 0.4, TapeKind.TAUT: 1.1, TapeKind.STRAIGHT: 0.0}
# How far before the body the tapes that run through it are drawn, as a fraction of its size.
CLEARANCE = 0.01
# Radius of the balls at the ends of open tapes, in the tape's own radii.
BALL = 1.9


def tape_tube(points: Array, lift: Array, free: Bools, kind: TapeKind) -> TapeTube:
    """Make the tube of a tape, with balls at its ends if it is open.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
    lift : ndarray, shape (k, 3)
        Directions in which the tube stands off the body.
    free : ndarray of bool, shape (k,)
        Whether the tape stands free of the body.
    kind : TapeKind
    """
    colors = tape_colors(free, kind)
    shell = tube(points, 1.0, colors)
    sides = len(shell.points) // len(points)
    away = LIFT[kind] * lift
    offset = np.repeat(away, sides, axis=0) + THICKNESS[kind] * shell.normals
    parts = [TapeTube(np.repeat(points, sides, axis=0), offset, shell)]
    if not np.array_equal(points[0], points[-1]):
        sphere = _sphere()
        for end in (0, -1):
            base = np.broadcast_to(points[end], sphere.points.shape)
            offset = away[end] + BALL * THICKNESS[kind] * sphere.normals
            color = np.broadcast_to(colors[end], base.shape)
            mesh = Mesh(base, sphere.normals, sphere.triangles, color, sphere.owner)
            parts.append(TapeTube(base, offset, mesh))
    return TapeTube(
        np.concatenate([part.base for part in parts]),
        np.concatenate([part.offset for part in parts]),
        joined([part.mesh for part in parts]),
    )


@cache
def _sphere() -> Mesh:
    return ball(np.zeros(3), 1.0, np.ones(3), 0)


def tape_colors(free: Bools, kind: TapeKind) -> Array:
    """Return the color of a tape at each of its points, shape (k, 3)."""
    colors = np.tile(COLORS[kind], (len(free), 1))
    if kind is TapeKind.TAUT:
        band = np.arange(len(colors)) // BAND_POINTS % 2 == 1
        colors[band & free] = BAND
    return colors


def tape_mesh(lines: Sequence[TapeLine], radius: float, forward: Array) -> Mesh:
    """Join the tubes of some tapes.

    Parameters
    ----------
    lines : sequence of TapeLine
    radius : float
        Radius of contact tapes, in the atlas's unit.
    forward : ndarray, shape (3,)
        By how much tapes that run through the body are moved, to be drawn over it.

    Returns
    -------
    Mesh
        Each triangle's owner is the position of its tape among `lines`.
    """
    parts = []
    for owner, line in enumerate(lines):
        base, offset, mesh = line.tube
        points = base + radius * offset
        if line.through_body:
            points += forward
        owners = np.full(len(mesh.triangles), owner)
        parts.append(Mesh(points, mesh.normals, mesh.triangles, mesh.colors, owners))
    return joined(parts)


def forward(scene: TapeScene, lines: Sequence[TapeLine], view: View) -> Array:
    """Return the move towards the viewer, shape (3,), that brings all tapes before the body.

    In an orthographic picture it changes nothing else.
    """
    body = scene.surface.points @ view.towards
    tapes = [(line.points @ view.towards).min() for line in lines if line.through_body]
    way = body.max() - min(tapes, default=body.max()) + CLEARANCE * scene.size
    return np.asarray(way * view.towards)
