"""Tapes measured over triangles, against which their lengths are held."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from bodymeasure.viewer.content.requests import MeasureOnMesh, Place
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.atlas import Atlas, AtlasPoint, Tessellation, tessellate
from bodymeasure.atlas.queries.locations import atlas_point
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.mesh import measure_mesh

# Steps along a patch's side of the finer mesh, as a part of those that are drawn; the coarser one
# has half as many. A tape of a body takes a second over both.
FINER = 2
# The least that leaves steps for the coarser one.
LEAST = 2


def mesh_answer(
    body: ShownBody,
    request: MeasureOnMesh,
    progress: Callable[[int, int], None] | None = None,
) -> dict[str, Any]:
    """Return the lengths of tapes over meshes of two sizes, extrapolated to none.

    Parameters
    ----------
    body : ShownBody
    request : MeasureOnMesh
    progress : callable, optional
        Is told of each tape.

    Returns
    -------
    dict of str to object
        ``lengths`` in meters; None of a tape that has none on a mesh.

    Raises
    ------
    InputError
        If a point is none, or the body has so many patches that they are as small as triangles.
    """
    finer = body.segments // FINER
    if finer < LEAST:
        raise InputError(
            f"{body.name} has {len(body.atlas)} patches, which are as small as triangles, so that "
            "no mesh of it is worth comparing with"
        )
    meshes = [_mesh(body.atlas, steps) for steps in (finer // 2, finer)]
    lengths = []
    for number, places in enumerate(request.tapes, start=1):
        lengths.append(_length(body, meshes, places))
        if progress is not None:
            progress(number, len(request.tapes))
    return {"lengths": lengths}


@lru_cache(maxsize=4)
def _mesh(atlas: Atlas, steps: int) -> Tessellation:
    return tessellate(atlas, steps)


def _length(body: ShownBody, meshes: list[Tessellation], places: tuple[Place, ...]) -> float | None:
    atlas = body.atlas
    points = [atlas.position(atlas_point(atlas, AtlasPoint(*place), "a point")) for place in places]
    found = []
    for mesh in meshes:
        try:
            path = measure_mesh((mesh.vertices, mesh.faces), points[0], points[-1], points[1:-1])
        except (ConvergenceError, InputError):
            return None
        found.append(path.length)
    coarse, fine = found
    # Lengths over triangles are off by the square of the triangles' size.
    length = (fine + (fine - coarse) / 3.0) * body.meters
    return float(length) if np.isfinite(length) else None
