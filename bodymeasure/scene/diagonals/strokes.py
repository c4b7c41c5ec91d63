"""The picture of a survey's scene: its surface, and the curves on it."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import EDGE, FADED_EDGE, ColorScale, path_colors
from bodymeasure.scene.drawing.picture import Picture, Stroke
from bodymeasure.scene.model import BodyScene, PathKind, Polylines

# The number of dashes of a path without a length: enough to be seen as dashes, and few enough to
# stay apart in a picture of the whole body.
DASHES = 6
# How far curves are lifted off the surface towards the viewer, as a fraction of the picture's
# height: above the distance of the mesh from the curved surface (0.3 mm in a close-up of 10 cm),
# and below what would show a curve through a fold of the body.
LIFT = 0.004
# A curve is left out where the cosine between the surface's normal and the line of sight is less
# than this: along a silhouette, a pixel cannot separate what lies before and behind it.
GRAZING = 0.1
# Width of the edges around the patch of a close-up, as a fraction of that of the patch's own.
FADED_WIDTH = 0.45
# Paths without a length are wider by this factor, to make up for what the dashes take away.
NO_LENGTH_WIDTH = 1.35


@dataclass(frozen=True)
class Style:
    """Height of a picture, and widths of its lines, in pixels."""

    height: int
    edge_width: float
    path_width: float


BODY_STYLE = Style(height=1100, edge_width=0.8, path_width=1.9)
CLOSEUP_STYLE = Style(height=640, edge_width=2.0, path_width=3.6)


def scene_picture(scene: BodyScene, view: View, scale: ColorScale | None, style: Style) -> Picture:
    """Describe the picture of a scene.

    Parameters
    ----------
    scene : BodyScene
    view : View
    scale : ColorScale or None
        Colors of the compared paths.
    style : Style
    """
    drawn = strokes(scene, view, scale, style)
    return Picture(scene.surface, view, view.size(style.height), strokes=drawn)


def strokes(scene: BodyScene, view: View, scale: ColorScale | None, style: Style) -> list[Stroke]:
    """List the curves on a scene's surface: edges first, then paths with the worst on top."""
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


def lifted(lines: Polylines, view: View) -> Array:
    """Move curves towards the viewer, shape (n, k, 3), with NaN along silhouettes."""
    points = lines.points + (LIFT * view.height) * view.towards
    points[np.abs(lines.normals @ view.towards) < GRAZING] = np.nan
    return points


def _uniform(points: Array, color: tuple[float, float, float], width: float) -> Stroke:
    return Stroke(points, np.tile(color, (len(points), 1)), width)


def dashed(points: Array) -> Array:
    """Cut curves into `DASHES` dashes with gaps of NaN between them."""
    phase = np.linspace(0.0, 2 * DASHES - 1, points.shape[1])
    dashed = points.copy()
    dashed[:, np.floor(phase).astype(int) % 2 == 1] = np.nan
    return dashed
