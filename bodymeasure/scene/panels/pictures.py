"""A body with the panels of a pattern on it, colored by how much their cloth has to give."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.mesh.tubes import Mesh, joined
from bodymeasure.pattern import Pattern, Piece, strain_colors
from bodymeasure.scene.camera import View, framed
from bodymeasure.scene.diagonals.build import BODY_SEGMENTS, tessellate
from bodymeasure.scene.drawing.picture import Picture, Stroke
from bodymeasure.scene.drawing.sides import SidePictures, side_pictures
from bodymeasure.scene.fits.pictures import Triangles, vertex_normals

SIDES = ("front", "left", "right", "back")
# A side from which less than this part of the panels faces the viewer is not drawn.
SEEN = 0.15
# Shown at half their size, for displays with twice the usual resolution.
PIXELS = 900
# In meters: panels lie so far outside the skin, which would show through them else, and their
# edges so far outside of them.
LIFT, EDGE_LIFT = 0.002, 0.0008
# Room around the panels, as a part of their height, and how much before them, in meters, is shown:
# an arm would hide a side.
MARGIN, BEFORE = 0.12, 0.01
EDGE = (0.1, 0.1, 0.12)
# The widths of edges and darts in pixels of the picture.
WIDTH = 3.0


def panel_pictures(
    pattern: Pattern,
    *,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> SidePictures:
    """Draw a body with the panels of a pattern on it.

    Parameters
    ----------
    pattern : Pattern
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.
    advance : callable, optional
        Called after each picture with its name.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    return side_pictures(_pictures(pattern), renderer=renderer, advance=advance)


def _pictures(pattern: Pattern) -> Iterator[tuple[str, Picture]]:
    """Yield what is seen from each side that shows panels."""
    atlas, meters = pattern.atlas, pattern.atlas.unit.meters
    surface = tessellate(atlas, np.arange(len(atlas)), BODY_SEGMENTS)
    parts, strokes = zip(*(_panel(pattern, piece) for piece in pattern.pieces), strict=True)
    panels = joined(parts)
    for side, towards in _directions(pattern).items():
        if (panels.normals @ towards > 0.5).mean() >= SEEN:
            view = _view(panels.points, towards, atlas.axes.up_vector, BEFORE / meters)
            yield side, Picture(surface, view, view.size(PIXELS), panels, strokes)


def _panel(pattern: Pattern, piece: Piece) -> tuple[Mesh, Stroke]:
    """Return a panel on the skin, and its edges and darts."""
    atlas, mesh = pattern.atlas, piece.flat.mesh
    meters = atlas.unit.meters
    skin = evaluate(atlas.control_points[mesh.places.patch], mesh.places.parameters)
    # Counterclockwise is as seen from outside, unless the atlas faces inwards.
    normals = vertex_normals(Triangles(skin, mesh.triangles))
    x, y = piece.outline.T
    if x @ np.roll(y, -1) < y @ np.roll(x, -1):
        normals = -normals
    points = skin + LIFT / meters * normals
    colors = strain_colors(_at_vertices(piece))
    owner = np.zeros(len(mesh.triangles), dtype=np.int64)
    chains = [chain.vertices for edge in mesh.edges for chain in edge]
    chains += [leg.vertices for dart in mesh.darts for leg in (dart.before, dart.after)]
    lines = np.full((len(chains), max(map(len, chains)), 3), np.nan)
    for line, vertices in zip(lines, chains, strict=True):
        line[: len(vertices)] = points[vertices] + EDGE_LIFT / meters * normals[vertices]
    stroke = Stroke(lines, np.tile(EDGE, (len(lines), 1)), WIDTH)
    return Mesh(points, normals, mesh.triangles, colors, owner), stroke


def _at_vertices(piece: Piece) -> Array:
    """Return the strain at each vertex, as the mean of the triangles around it by their areas."""
    triangles = piece.flat.mesh.triangles
    area = piece.flat.stretch.area
    strain = np.abs(piece.strains).max(axis=1)
    count = len(piece.positions)
    total = sum(np.bincount(corner, area * strain, count) for corner in triangles.T)
    weight = sum(np.bincount(corner, area, count) for corner in triangles.T)
    return np.asarray(total / np.maximum(weight, np.finfo(float).tiny))


def _directions(pattern: Pattern) -> dict[str, Array]:
    axes = pattern.atlas.axes
    front, left = axes.front_vector, axes.left_vector
    return dict(zip(SIDES, (front, left, -left, -front), strict=True))


def _view(points: Array, towards: Array, up: Array, before: float) -> View:
    view = framed(points, towards, up, MARGIN * float(np.ptp(points @ up)))
    nearest = float(((points - view.center) @ towards).max()) + before
    return replace(view, nearest=nearest)
