"""Tapes as colored tubes: how contact, taut and straight ones look."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from bodymeasure.chart import TapeKind
from bodymeasure.mesh.tubes import Mesh, ball, joined, tube
from bodymeasure.scene.camera import View
from bodymeasure.scene.model import TapeLine, TapeScene

# Okabe and Ito's blue and vermilion, told apart by all color-blind readers, and nearly black.
COLORS: Mapping[TapeKind, tuple[float, float, float]] = {
    TapeKind.CONTACT: (0.0, 0.40, 0.72),
    TapeKind.TAUT: (0.88, 0.38, 0.0),
    TapeKind.STRAIGHT: (0.16, 0.16, 0.20),
}
# A taut tape is banded with this where it stands free of the body.
BAND = (1.0, 0.93, 0.72)
BAND_POINTS = 3
# Radii as parts of a contact tape's: where both lie on the skin, the taut one runs along the back
# of the other, and both are seen.
THICKNESS: Mapping[TapeKind, float] = {
    TapeKind.CONTACT: 1.0,
    TapeKind.TAUT: 0.62,
    TapeKind.STRAIGHT: 0.6,
}
# How far the middle of a tube stands off the skin, in a contact tape's radii: above the skin's
# tessellation, so that no tube sinks into it.
LIFT: Mapping[TapeKind, float] = {TapeKind.CONTACT: 0.4, TapeKind.TAUT: 1.1, TapeKind.STRAIGHT: 0.0}
# How far before the body those that run through it are drawn, as a fraction of its size.
CLEARANCE = 0.01
# Balls at the ends of open tapes, in the tape's own radii.
BALL = 1.9


def tape_mesh(lines: Sequence[TapeLine], radius: float, forward: NDArray[np.float64]) -> Mesh:
    """Tubes of some tapes.

    Parameters
    ----------
    lines : sequence of TapeLine
    radius : float
        Of contact tapes, in the atlas's unit.
    forward : ndarray, shape (3,)
        By how much tapes that run through the body are moved, to be drawn over it.

    Returns
    -------
    Mesh
        Each triangle's owner is the position of its tape among `lines`.
    """
    parts = []
    for owner, line in enumerate(lines):
        points = line.points + LIFT[line.kind] * radius * line.lift
        if line.through_body:
            points = points + forward
        colors = tape_colors(line)
        thickness = THICKNESS[line.kind] * radius
        parts.append(tube(points, thickness, colors, owner))
        if not np.array_equal(line.points[0], line.points[-1]):
            parts += [ball(points[end], BALL * thickness, colors[end], owner) for end in (0, -1)]
    return joined(parts)


def forward(scene: TapeScene, lines: Sequence[TapeLine], view: View) -> NDArray[np.float64]:
    """A way towards the viewer, shape (3,), on which all tapes get before the body.

    In an orthographic picture a move along it does nothing else.
    """
    body = scene.surface.points @ view.towards
    tapes = [(line.points @ view.towards).min() for line in lines if line.through_body]
    way = body.max() - min(tapes, default=body.max()) + CLEARANCE * scene.size
    return np.asarray(way * view.towards)


def tape_colors(line: TapeLine) -> NDArray[np.float64]:
    """Color of a tape at each of its points, shape (k, 3)."""
    colors = np.tile(COLORS[line.kind], (len(line.points), 1))
    if line.kind is TapeKind.TAUT:
        band = np.arange(len(colors)) // BAND_POINTS % 2 == 1
        colors[band & line.free] = BAND
    return colors
