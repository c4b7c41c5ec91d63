"""The message that shows a body: its surface, its seams, its landmarks, and what is known of it."""

import hashlib
from typing import Any

import numpy as np
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import packed

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import EDGES, Atlas, approximation_sentences, edge_table
from bodymeasure.atlas.seams import AXIS, VALUE

LAYERS = ("nets", "diagonals", "boundary")


def body_message(body: ShownBody, extra: dict[str, Any] | None = None) -> bytes:
    """Return the message of a body.

    Parameters
    ----------
    body : ShownBody
    extra : dict, optional
        More members of the header.
    """
    atlas, segments = body.atlas, body.segments
    count, steps = len(atlas), segments + 1
    ticks = np.linspace(0.0, 1.0, steps)
    grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(1, -1, 2)
    points, normals = body.surface(np.arange(count), np.broadcast_to(grid, (count, steps**2, 2)))
    seams, seam_normals = seam_lines(body)
    regions = list(dict.fromkeys(region for region in atlas.regions if region))
    flat = points.reshape(-1, 3)
    header = {
        "version": body.version,
        "id": body.id,
        "name": body.name,
        "file": body.file,
        "unit": atlas.unit.value,
        "patches": count,
        "segments": segments,
        "regions": regions,
        "patch_region": [regions.index(region) if region else -1 for region in atlas.regions],
        "patch_names": list(atlas.patch_names),
        "landmarks": landmark_records(body),
        "bounds": [flat.min(axis=0).tolist(), flat.max(axis=0).tolist()],
        "layers": list(LAYERS),
        "warnings": [*body.warnings, *approximation_sentences(atlas, atlas.unit)],
        "layout": layout_of(atlas),
        "mark": body.mark,
        "place": body.place,
        **body.start,
        **(extra or {}),
    }
    shape = (count, steps, steps, 3)
    return packed(
        header,
        {
            "positions": points.reshape(shape),
            "normals": normals.reshape(shape),
            "seams": seams,
            "seam_normals": seam_normals,
        },
    )


def seam_sides(atlas: Atlas) -> Ints:
    """Return a patch and a side, as in `EDGES`, of each distinct edge, shape (k, 2)."""
    _, first = np.unique(edge_table(atlas.index).edge, return_index=True)
    return np.stack(np.divmod(first, len(EDGES)), axis=1)


def along_side(side: Ints, along: Array) -> Array:
    """Return parameters (k, m, 2) along sides (k,) of patches, at the free parameter (m,)."""
    parameters = np.empty((len(side), len(along), 2))
    rows = np.arange(len(side))
    parameters[rows, :, AXIS[side]] = VALUE[side][:, None]
    parameters[rows, :, 1 - AXIS[side]] = along
    return parameters


def seam_lines(body: ShownBody) -> tuple[Array, Array]:
    """Return points and normals along all edges, each once, at the vertices of the triangles."""
    patch, side = seam_sides(body.atlas).T
    ticks = np.linspace(0.0, 1.0, body.segments + 1)
    return body.surface(patch, along_side(side, ticks))


def landmark_records(body: ShownBody) -> list[dict[str, Any]]:
    """Return the landmarks of a body's atlas as the page knows them."""
    atlas = body.atlas
    found = {} if atlas.scan is None else atlas.scan.landmarks
    return [
        {
            "name": name,
            "location": list(place),
            "position": body.positions_on_page(atlas.position(place)).tolist(),
            "origin": found[name].origin.value if name in found else "file",
        }
        for name, place in atlas.landmarks.items()
    ]


def layout_of(atlas: Atlas) -> str:
    """Return a hash of how patches share control points; bodies with the same are comparable."""
    content = np.ascontiguousarray(atlas.index, dtype="<i8").tobytes()
    return hashlib.sha256(content + repr(atlas.index.shape).encode()).hexdigest()[:16]
