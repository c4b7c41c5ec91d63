"""The side of its patches on which the outside of a body lies."""

from typing import Literal

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EdgeTable
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.atlas.topology.joins import parts, round_of_side, seams_of, turned_patches
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError

Outside = Literal["determined", "along normals", "against normals"]
"""Determined from what the surface encloses, or where S_u x S_v points, or the opposite side."""

# Part of a part's area: openings that together are larger leave no body to speak of. A body that is
# trimmed at neck and wrists has 1 %, a torso cut at neck, arms and thighs some 20 %, a bowl 50 %,
# and a sheet all.
LARGEST_OPENING = 0.25
# Volume over area to the power 1.5: 0.094 for a ball, 0.02 for a body, 0 for what folds flat.
LEAST_VOLUME = 1e-3
# Steps along a patch's side at which a volume is sampled whose sign alone matters.
STEPS = 4


def outward_sign(atlas: Atlas) -> float:
    """Return 1 where the patches' normals S_u x S_v point out of the body, -1 where into it.

    Notes
    -----
    It is the sign of the volume between the patches and the middle of the body, which openings do
    not spoil. All patches are taken to face alike, which `bodymeasure.check_atlas` checks.
    """
    side = np.linspace(0.0, 1.0, STEPS + 1)
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    samples = evaluate(atlas.control_points, np.broadcast_to(grid, (len(atlas), *grid.shape)))
    _, volume = _triangle_sums(samples)
    return -1.0 if volume.sum() < 0.0 else 1.0


def outward_sign_of_mesh(vertices: Array, faces: Ints) -> float:
    """Return 1 where the faces (f, 3) of a mesh face out of the body, -1 where into it."""
    volume = _volumes(*(vertices - vertices.mean(axis=0))[faces].swapaxes(0, 1))
    return -1.0 if volume.sum() < 0.0 else 1.0


def outward_signs(atlas: Atlas, samples: Array, table: EdgeTable, outside: Outside) -> Array:
    """Return by what S_u x S_v is multiplied to point out of the body, 1 or -1 for each patch.

    Parameters
    ----------
    atlas : Atlas
    samples : ndarray, shape (patches, k, k, 3)
        Positions on an even grid over each patch, edges included.
    table : EdgeTable
        The atlas's own.
    outside : {"determined", "along normals", "against normals"}

    Raises
    ------
    InputError
        If a part of the atlas has only one side, or is so open that its inside cannot be
        determined.

    Notes
    -----
    Patches of a part are first made to face the same way. The part's openings are closed by cones;
    the outside is where the volume so enclosed, by the divergence theorem, is positive.
    """
    seams = seams_of(table, table.collapsed)
    turned, one_sided = turned_patches(seams, len(atlas))
    if one_sided:
        name = atlas.patch_names[one_sided[0][0]]
        raise InputError(
            f"the part of the atlas with patch {name!r} has only one side, like a Moebius band, so "
            "that no tape lies outside it; check the atlas with bodymeasure.check_atlas"
        )
    signs = np.ones(len(atlas))
    signs[turned] = -1.0
    if outside == "along normals":
        return signs
    if outside == "against normals":
        return -signs
    part = parts(seams, len(atlas))
    area, volume = _triangle_sums(samples)
    cap_area, cap_volume = _caps(samples, table, signs, part)
    count = int(part.max()) + 1
    total_area = np.bincount(part, weights=area, minlength=count)
    total_volume = np.bincount(part, weights=signs * volume, minlength=count) + cap_volume
    unknown = (cap_area > LARGEST_OPENING * total_area) | (
        np.abs(total_volume) < LEAST_VOLUME * total_area**1.5
    )
    if unknown.any():
        first = int(np.flatnonzero(unknown)[0])
        raise InputError(_unknown(atlas, np.flatnonzero(part == first)))
    return np.asarray(signs * np.sign(total_volume)[part])


def _unknown(atlas: Atlas, patches: Ints) -> str:
    others = f" and {len(patches) - 1} more" if len(patches) > 1 else ""
    return (
        f"the outside of patch {atlas.patch_names[patches[0]]!r}{others} cannot be determined: the "
        "part encloses no body, or its openings are too large; say outside='along normals' (where "
        "S_u x S_v points) or outside='against normals', or join the patches' edges"
    )


def _triangle_sums(samples: Array) -> tuple[Array, Array]:
    """Area and signed volume (seen from the samples' center) of each patch, shapes (patches,)."""
    local = samples - samples.mean(axis=(0, 1, 2))
    a, b = local[:, :-1, :-1], local[:, 1:, :-1]
    c, d = local[:, 1:, 1:], local[:, :-1, 1:]
    area, volume = np.zeros(len(samples)), np.zeros(len(samples))
    for first, second, third in ((a, b, c), (a, c, d)):
        normal = np.cross(second - first, third - first)
        area += 0.5 * np.linalg.norm(normal, axis=-1).sum(axis=(1, 2))
        volume += _volumes(first, second, third).sum(axis=(1, 2))
    return area, volume


def _volumes(first: Array, second: Array, third: Array) -> Array:
    """Signed volumes of the tetrahedra from the origin to triangles with corners (..., 3)."""
    normal = np.cross(second - first, third - first)
    return np.asarray((first * normal).sum(axis=-1) / 6.0)


def _caps(samples: Array, table: EdgeTable, signs: Array, part: Ints) -> tuple[Array, Array]:
    """Area and signed volume of the cones that close each part's openings, shapes (parts,)."""
    count = int(part.max()) + 1
    area, volume = np.zeros(count), np.zeros(count)
    open_sides = (table.sides[table.edge] == 1) & ~table.collapsed
    patch, side = np.nonzero(open_sides)
    if not len(patch):
        return area, volume
    local = samples - samples.mean(axis=(0, 1, 2))
    edges = np.stack([local[:, 0], local[:, -1], local[:, :, 0], local[:, :, -1]], axis=1)
    lines = edges[patch, side]
    # The way round the cap runs against the way round the patch.
    backwards = round_of_side(side) == (signs[patch] > 0.0)
    lines[backwards] = lines[backwards, ::-1]
    ends = table.control_index[patch, side][:, [0, -1]]
    nodes, corner = np.unique(ends, return_inverse=True)
    corner = corner.reshape(-1, 2)
    loop = connected_components(corner[:, 0], corner[:, 1], len(nodes))[corner[:, 0]]
    for number in np.unique(loop):
        chosen = lines[loop == number]
        apex = chosen.mean(axis=(0, 1))
        first, second = chosen[:, :-1] - apex, chosen[:, 1:] - apex
        vector_area = 0.5 * np.cross(first, second).sum(axis=(0, 1))
        owner = part[patch[loop == number][0]]
        area[owner] += np.linalg.norm(vector_area)
        volume[owner] += apex @ vector_area / 3.0
    return area, volume
