"""Curves cut into the pieces that are drawn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import EDGE, FADED_EDGE, ColorScale, path_colors
from bodymeasure.scene.model import BodyScene, PathKind, Polylines

# Dashes of a path without a length, over its whole run: enough to be seen as dashes, few enough to
# stay apart in a picture of the body.
DASHES = 6
# How far curves are lifted off the surface towards the viewer, as a fraction of the picture's
# height: above the mesh's distance from the curved surface (0.3 mm in a close-up of 10 cm), and
# below what would show a curve through a fold of the body.
LIFT = 0.004
# Where the surface is seen at a flatter angle than this (its cosine with the normal), a curve is
# left out: along a silhouette, what lies before and behind it cannot be told apart in a pixel.
GRAZING = 0.1
# Edges around a patch in its close-up are drawn narrower by this.
FADED_WIDTH = 0.45
# Paths without a length are drawn wider, for what the dashes take away.
NO_LENGTH_WIDTH = 1.35


@dataclass(frozen=True)
class Style:
    """Widths of lines, in pixels of the finished picture."""

    edge_width: float
    path_width: float


BODY_STYLE = Style(edge_width=0.8, path_width=1.9)
CLOSEUP_STYLE = Style(edge_width=2.0, path_width=3.6)


@dataclass(frozen=True)
class Stroke:
    """Curves of one color and width, in the order of drawing.

    Parameters
    ----------
    points : ndarray, shape (n, k, 3)
        With NaN in gaps; lifted off the surface, towards the viewer.
    colors : ndarray, shape (n, 3)
    width : float
        In pixels.
    """

    points: NDArray[np.float64]
    colors: NDArray[np.float64]
    width: float


def strokes(scene: BodyScene, view: View, scale: ColorScale | None, style: Style) -> list[Stroke]:
    """What to draw over a scene's surface: edges, then paths with the worst on top."""
    paths = scene.paths
    colors = path_colors(paths, scale)
    points = lifted(paths.lines, view)
    missing = paths.kind == PathKind.NO_LENGTH
    order = np.argsort(np.nan_to_num(paths.value[~missing]), kind="stable")
    return [
        _uniform(lifted(scene.faded_edges, view), FADED_EDGE, FADED_WIDTH * style.edge_width),
        _uniform(lifted(scene.edges, view), EDGE, style.edge_width),
        Stroke(points[~missing][order], colors[~missing][order], style.path_width),
        Stroke(dashed(points[missing]), colors[missing], NO_LENGTH_WIDTH * style.path_width),
    ]


def lifted(lines: Polylines, view: View) -> NDArray[np.float64]:
    """Points of curves, shape (n, k, 3), moved towards the viewer; NaN along silhouettes."""
    points = lines.points + (LIFT * view.height) * view.towards
    points[np.abs(lines.normals @ view.towards) < GRAZING] = np.nan
    return points


def _uniform(
    points: NDArray[np.float64], color: tuple[float, float, float], width: float
) -> Stroke:
    return Stroke(points, np.tile(color, (len(points), 1)), width)


def runs(points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The pieces between a curve's gaps.

    Parameters
    ----------
    points : ndarray, shape (k, d)
        With NaN in gaps.

    Returns
    -------
    list of ndarray, shape (at least 2, d)
    """
    present = np.concatenate([[False], np.isfinite(points).all(axis=-1), [False]])
    bounds = np.flatnonzero(present[1:] != present[:-1]).reshape(-1, 2)
    return [points[first:last] for first, last in bounds if last - first > 1]


def dashed(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Curves with gaps between `DASHES` dashes."""
    phase = np.linspace(0.0, 2 * DASHES - 1, points.shape[1])
    dashed = points.copy()
    dashed[:, np.floor(phase).astype(int) % 2 == 1] = np.nan
    return dashed
