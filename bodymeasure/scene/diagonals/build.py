"""Build the scene that the pictures of a survey show."""

from typing import TYPE_CHECKING

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import EDGES, Atlas, edge_table
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.bezier import evaluate
from bodymeasure.scene.model import BodyScene, Label, PathKind, Paths, Polylines, Surface

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

# Segments along a patch's side. A mannequin's patch is some 7 cm wide: 8 segments keep the mesh
# within a few tenths of a millimeter of the surface, less than a pixel of a picture of the body.
BODY_SEGMENTS = 8
CLOSEUP_SEGMENTS = 24
# Points along curves: a curve that is partly hidden ends at one of them.
PATH_POINTS = 97
EDGE_POINTS = 49
# How far outside (u, v) in [0, 1] a path that leaves its patch is drawn; farther out, the
# polynomial soon has nothing to do with the body.
OVERSHOOT = 0.25


def body_scene(survey: "Survey", *, segments: int = BODY_SEGMENTS) -> BodyScene:
    """Build the scene of all patches of a survey with their edges and both diagonals.

    Parameters
    ----------
    survey : Survey
    segments : int
        Segments along a side of each patch.
    """
    atlas = survey.atlas
    everything = np.arange(len(atlas))
    return BodyScene(
        surface=tessellate(atlas, everything, segments),
        edges=_edges(atlas, everything),
        faded_edges=_edges(atlas, everything[:0]),
        paths=_paths(survey, everything),
    )


def patch_scene(survey: "Survey", patch: int) -> BodyScene:
    """Build the scene of one patch and its diagonals, with the rest of the body paler around it."""
    atlas = survey.atlas
    only = np.array([patch])
    others = np.setdiff1d(np.arange(len(atlas)), only)
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    positions, _ = _surface_at(atlas, only, corners[None])
    near = tessellate(atlas, only, CLOSEUP_SEGMENTS)
    far = tessellate(atlas, others, BODY_SEGMENTS)
    return BodyScene(
        surface=Surface(
            np.concatenate([near.points, far.points]),
            np.concatenate([near.normals, far.normals]),
            np.concatenate([near.triangles, far.triangles + len(near.points)]),
            np.concatenate([near.patch, far.patch]),
            np.concatenate([near.faded, ~far.faded]),
        ),
        edges=_edges(atlas, only),
        faded_edges=_edges(atlas, others),
        paths=_paths(survey, only),
        labels=tuple(
            Label(position, f"({u:.0f}, {v:.0f})")
            for position, (u, v) in zip(positions[0], corners, strict=True)
        ),
    )


def tessellate(atlas: Atlas, patches: Ints, segments: int) -> Surface:
    """Divide some patches into triangles; each patch has vertices of its own."""
    ticks = np.linspace(0.0, 1.0, segments + 1)
    grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(1, -1, 2)
    points, normals = _surface_at(atlas, patches, grid)
    number = np.arange((segments + 1) ** 2).reshape(segments + 1, segments + 1)
    a, b = number[:-1, :-1].ravel(), number[1:, :-1].ravel()
    c, d = number[1:, 1:].ravel(), number[:-1, 1:].ravel()
    cell = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    offset = np.arange(len(patches))[:, None, None] * number.size
    return Surface(
        points.reshape(-1, 3),
        normals.reshape(-1, 3),
        (cell + offset).reshape(-1, 3),
        np.repeat(patches, len(cell)),
        np.zeros(points.size // 3, dtype=np.bool_),
    )


def _edges(atlas: Atlas, patches: Ints) -> Polylines:
    """Sample the sides of some patches, each distinct edge once."""
    _, first = np.unique(edge_table(atlas.index).edge[patches], return_index=True)
    row, side = np.divmod(first, len(EDGES))
    along = np.linspace(0.0, 1.0, EDGE_POINTS)
    parameters = np.empty((len(first), EDGE_POINTS, 2))
    for number, edge in enumerate(EDGES):
        on_side = side == number
        parameters[on_side, :, edge.fixed_axis] = edge.fixed_value
        parameters[on_side, :, 1 - edge.fixed_axis] = along
    return Polylines(*_surface_at(atlas, patches[row], parameters))


def _paths(survey: "Survey", patches: Ints) -> Paths:
    atlas, solution, check = survey.atlas, survey.diagonals, survey.cross_check
    t = np.linspace(0.0, 1.0, PATH_POINTS)
    parameters = solution.path(t)[patches]
    # A path that could not be computed at all is shown where it should have been.
    missing = np.asarray(~np.isfinite(parameters).all(axis=(-2, -1)))
    start, end = solution.start[patches], solution.end[patches]
    straight = start[..., None, :] + t[:, None] * (end - start)[..., None, :]
    parameters = np.where(missing[..., None, None], straight, parameters)
    far = ((parameters < -OVERSHOOT) | (parameters > 1.0 + OVERSHOOT)).any(axis=-1)

    count = 2 * len(patches)
    patch = np.repeat(patches, 2)
    parameters = parameters.reshape(count, PATH_POINTS, 2)
    points, normals = _surface_at(atlas, patch, parameters)
    points[far.reshape(count, PATH_POINTS)] = np.nan

    has_length = np.isfinite(solution.length[patches]).ravel()
    value = np.full(count, np.nan)
    if check is not None:
        value = np.abs(check.relative_difference[patches]).ravel()
    value[~has_length] = np.nan
    kind = np.full(count, PathKind.NO_LENGTH, dtype=object)
    kind[has_length] = PathKind.NOT_COMPARED
    kind[np.isfinite(value)] = PathKind.COMPARED
    diagonal = np.tile([0, 1], len(patches))
    return Paths(Polylines(points, normals), patch, diagonal, kind, value)


def _surface_at(atlas: Atlas, patches: Ints, parameters: Array) -> tuple[Array, Array]:
    """Return points and unit normals, (patches, k, 3), at parameters, (patches, k, 2)."""
    nets = atlas.control_points[patches]
    return evaluate(nets, parameters), unit_normals(nets, parameters)
