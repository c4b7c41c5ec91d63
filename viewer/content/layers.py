"""Lines over a body that were measured or that define it: control nets, diagonals, boundaries."""

from collections.abc import Callable
from typing import Any

import numpy as np
from bodymeasure.viewer.content.body import along_side, seam_sides
from bodymeasure.viewer.content.requests import ShowLayer
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import packed

from bodymeasure._typing import Array
from bodymeasure.atlas import EDGES
from bodymeasure.bezier import project
from bodymeasure.geodesic import GeodesicSolution, Status
from bodymeasure.measure import boundary_lengths, diagonals, measure_atlas

# Points along a diagonal and along a side of a patch.
DIAGONAL_POINTS = 33
SIDE_POINTS = 17
# How far outside (u, v) in [0, 1] a diagonal that leaves its patch is drawn.
OVERSHOOT = 0.25
ENDS = ("(0, 0) to (1, 1)", "(1, 0) to (0, 1)")
MEASURED = "The length holds to the stated error."
UNKNOWN = "The length is not known well enough; look for a cusp with `bodymeasure check`."


def layer_message(
    body: ShownBody, request: ShowLayer, progress: Callable[[int, int], None] | None = None
) -> bytes:
    """Return the lines of a layer, with what was measured along them."""
    if request.name == "nets":
        return _message(request, *_nets(body), [])
    if request.name == "boundary":
        return _boundary(body, request)
    return _diagonals(body, request, progress)


def _message(
    request: ShowLayer, points: Array, normals: Array, items: list[dict[str, Any]]
) -> bytes:
    return packed({"name": request.name, "items": items}, {"points": points, "normals": normals})


def _nets(body: ShownBody) -> tuple[Array, Array]:
    """Return the rows and columns of all control nets, which stand off the surface."""
    nets = body.positions_on_page(project(body.atlas.control_points))
    lines = np.concatenate([nets, nets.swapaxes(1, 2)], axis=1)
    points = lines.reshape(-1, *lines.shape[2:])
    return points, np.zeros_like(points)


def _boundary(body: ShownBody, request: ShowLayer) -> bytes:
    found = boundary_lengths(body.atlas)
    patch, side = seam_sides(body.atlas).T
    points, normals = body.surface(patch, along_side(side, np.linspace(0.0, 1.0, SIDE_POINTS)))
    items = []
    for number, edge in zip(patch.tolist(), side.tolist(), strict=True):
        known = bool(found.converged[number, edge])
        items.append(
            {
                "name": f"{body.atlas.patch_names[number]}, {EDGES[edge].name}",
                "patch": number,
                "length": _meters(body, found.length[number, edge], known=known),
                "error_estimate": _meters(body, found.error_estimate[number, edge]),
                "status": "converged" if known else "inaccurate",
                "words": MEASURED if known else UNKNOWN,
            }
        )
    return _message(request, points, normals, items)


def _diagonals(
    body: ShownBody, request: ShowLayer, progress: Callable[[int, int], None] | None
) -> bytes:
    atlas, differences = body.atlas, body.differences
    if request.compare and differences is None:
        every = 2 * len(atlas)
        tell = None if progress is None else lambda done: progress(done, every)
        survey = measure_atlas(atlas, progress=tell)
        solution, check = survey.diagonals, survey.cross_check
        differences = None if check is None else check.relative_difference
    else:
        solution = diagonals(atlas, on_failure="status")
    return diagonals_content(body, solution, differences)


def diagonals_content(
    body: ShownBody, solution: GeodesicSolution, differences: Array | None
) -> bytes:
    """Return the message of both diagonals of each patch.

    Parameters
    ----------
    body : ShownBody
    solution : GeodesicSolution
        Of shape (patches, 2).
    differences : ndarray, shape (patches, 2), optional
        Relative differences of the lengths from the mesh.
    """
    points, normals = diagonal_lines(body, solution)
    statuses, proven = np.asarray(solution.status), solution.proven_shortest
    items = []
    for patch, name in enumerate(body.atlas.patch_names):
        for number in range(2):
            status: Status = statuses[patch, number]
            item = {
                "name": f"{name}, {ENDS[number]}",
                "patch": patch,
                "length": _meters(body, solution.length[patch, number]),
                "error_estimate": _meters(body, solution.error_estimate[patch, number]),
                "status": status.name.lower(),
                "words": status.sentence,
                "proven": bool(proven[patch, number]),
            }
            if differences is not None and np.isfinite(differences[patch, number]):
                item["difference"] = float(differences[patch, number])
            items.append(item)
    header = {"name": "diagonals", "items": items}
    return packed(header, {"points": points, "normals": normals})


def diagonal_lines(body: ShownBody, solution: GeodesicSolution) -> tuple[Array, Array]:
    """Return points and normals along the diagonals, (2 patches, m, 3); NaN where there are none.

    A diagonal without a path is drawn where it should have been.
    """
    times = np.linspace(0.0, 1.0, DIAGONAL_POINTS)
    count = len(body.atlas)
    parameters = solution.path(times)
    missing = np.asarray(~np.isfinite(parameters).all(axis=(-2, -1)))
    start, end = solution.start[..., None, :], solution.end[..., None, :]
    straight = start + times[:, None] * (end - start)
    parameters = np.where(missing[..., None, None], straight, parameters)
    far = ((parameters < -OVERSHOOT) | (parameters > 1.0 + OVERSHOOT)).any(axis=-1)
    flat = parameters.reshape(2 * count, DIAGONAL_POINTS, 2)
    points, normals = body.surface(np.repeat(np.arange(count), 2), flat)
    points[far.reshape(points.shape[:2])] = np.nan
    return points, normals


def _meters(body: ShownBody, length: float, *, known: bool = True) -> float | None:
    return float(length) * body.meters if known and np.isfinite(length) else None
