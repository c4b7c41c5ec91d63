"""Numbers by which a body is colored: curvatures, angles at seams, the distance of another body."""

from typing import Any

import numpy as np
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.body import along_side, layout_of
from bodymeasure.viewer.content.requests import ShowQuantity
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import packed

from bodymeasure._typing import Array
from bodymeasure.atlas import edge_table
from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.errors import InputError

QUANTITIES = {
    "gaussian": "Gaussian curvature",
    "mean": "mean curvature",
    "seam_angle": "angle at seams",
    "distance": "distance from the other body",
}
# The percentage of all values that a scale shows with different colors; at a cusp, a curvature has
# no bound.
SHOWN = 98.0
# Sine of the angle between tangents that span no plane, and the part of the way to the middle of
# the patch at which curvatures are taken there instead.
DEGENERATE, ASIDE = 1e-6, 1e-3


def quantity_message(bodies: Bodies, request: ShowQuantity) -> bytes:
    """Return the values of a quantity with their scale."""
    body = bodies[request.body]
    if request.key == "seam_angle":
        return _message(body, request, seam_angles(body), "deg", per="seam")
    if request.key == "distance":
        other = bodies[request.other]
        return _message(body, request, distances(body, other), "m")
    gaussian, mean = curvatures(body)
    if request.key == "gaussian":
        return _message(body, request, gaussian, "1/m²", signed=True)
    return _message(body, request, mean, "1/m", signed=True)


def _message(
    body: ShownBody,
    request: ShowQuantity,
    values: Array,
    unit: str,
    *,
    signed: bool = False,
    per: str = "vertex",
) -> bytes:
    known = np.abs(values[np.isfinite(values)])
    high = float(np.percentile(known, SHOWN)) if known.size else 0.0
    words = {
        "gaussian": "The product of the principal curvatures of the smooth surface: positive on "
        "domes, negative on saddles.",
        "mean": "The mean of the principal curvatures of the smooth surface: positive where it "
        "bulges outwards, negative in hollows.",
        "seam_angle": "The angle by which the surface's normal jumps across a seam; boundaries "
        "have none.",
        "distance": "How far the same place of the other body is, after that one was moved and "
        "turned to fit best.",
    }[request.key]
    header: dict[str, Any] = {
        "key": request.key,
        "label": QUANTITIES[request.key],
        "unit": unit,
        "low": -high if signed else 0.0,
        "high": high,
        "scale": "diverging" if signed else "sequential",
        "per": per,
        "largest": float(known.max()) if known.size else 0.0,
        "words": f"{words} The scale ends where {100.0 - SHOWN:.0f} % of the values are beyond.",
        "body": body.id,
    }
    return packed(header, {"values": values})


def _grid(body: ShownBody) -> Array:
    """Return the parameters of a patch's vertices, shape (steps * steps, 2)."""
    ticks = np.linspace(0.0, 1.0, body.segments + 1)
    return np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)


def curvatures(body: ShownBody) -> tuple[Array, Array]:
    """Return the Gaussian and the mean curvature at the vertices, (patches, steps, steps).

    They are exact, from the derivatives of the patches, in meters. A sphere of radius r has
    1 / r^2 and 1 / r. Where the tangents span no plane, as at a pole, they are those a little
    nearer to the middle of the patch.
    """
    count, steps = len(body.atlas), body.segments + 1
    parameters = np.broadcast_to(_grid(body), (count, steps**2, 2))
    jets = derivatives(body.atlas.control_points, parameters, order=2)
    sine = _sine(jets)
    bad = sine < DEGENERATE
    if bad.any():
        aside = np.where(bad[..., None], parameters + ASIDE * (0.5 - parameters), parameters)
        jets = derivatives(body.atlas.control_points, aside, order=2)
    gaussian, mean = _of_jets(jets)
    outwards = body.signs[:, None]
    shape = (count, steps, steps)
    return (gaussian / body.meters**2).reshape(shape), (-outwards * mean / body.meters).reshape(
        shape
    )


def _sine(jets: Array) -> Array:
    """Return the sines of the angles between the tangents."""
    along_u, along_v = jets[..., 1, 0, :], jets[..., 0, 1, :]
    product = np.linalg.norm(along_u, axis=-1) * np.linalg.norm(along_v, axis=-1)
    cross = np.linalg.norm(np.cross(along_u, along_v), axis=-1)
    return np.divide(cross, product, out=np.zeros_like(cross), where=product > 0.0)


def _of_jets(jets: Array) -> tuple[Array, Array]:
    """Return Gaussian and mean curvature, the latter along S_u x S_v; NaN where there is none."""
    su, sv = jets[..., 1, 0, :], jets[..., 0, 1, :]
    cross = np.cross(su, sv)
    area = np.linalg.norm(cross, axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        normal = cross / area[..., None]
        e, f, g = ((a * b).sum(axis=-1) for a, b in ((su, su), (su, sv), (sv, sv)))
        second = (jets[..., 2, 0, :], jets[..., 1, 1, :], jets[..., 0, 2, :])
        m, n, o = ((a * normal).sum(axis=-1) for a in second)
        gaussian = (m * o - n**2) / area**2
        mean = (e * o - 2.0 * f * n + g * m) / (2.0 * area**2)
    return gaussian, mean


def seam_angles(body: ShownBody) -> Array:
    """Return the angles in degrees between the normals of both sides of each edge, (edges, steps).

    They are NaN along boundaries, and where more than two sides meet.
    """
    atlas, steps = body.atlas, body.segments + 1
    table = edge_table(atlas.index)
    edge = table.edge.ravel()
    order = np.argsort(edge, kind="stable")
    starts = np.searchsorted(edge[order], np.arange(len(table.sides)))
    angles = np.full((len(table.sides), steps), np.nan)
    double = np.flatnonzero(table.sides == 2)
    first, second = order[starts[double]], order[starts[double] + 1]
    ticks = np.linspace(0.0, 1.0, steps)
    normals = []
    for sides in (first, second):
        patch, side = np.divmod(sides, 4)
        normals.append(body.surface(patch, along_side(side, ticks))[1])
    against = table.reversed.ravel()[first] != table.reversed.ravel()[second]
    normals[1][against] = normals[1][against, ::-1]
    sine = np.linalg.norm(np.cross(*normals), axis=-1)
    cosine = (normals[0] * normals[1]).sum(axis=-1)
    angles[double] = np.degrees(np.arctan2(sine, cosine))
    return angles


def distances(body: ShownBody, other: ShownBody) -> Array:
    """Return how far the same places of two bodies are apart, in meters, (patches, steps, steps).

    Raises
    ------
    InputError
        If the bodies do not have the same patches.
    """
    if layout_of(body.atlas) != layout_of(other.atlas):
        raise InputError(
            f"{body.name} and {other.name} have different patches, so that no place of one is the "
            "same as one of the other; fit both by the same model to compare them"
        )
    count, steps = len(body.atlas), body.segments + 1
    grid = np.broadcast_to(_grid(body), (count, steps**2, 2))
    here, there = (
        each.positions_on_page(evaluate(each.atlas.control_points, grid)).reshape(-1, 3)
        for each in (body, other)
    )
    apart: Array = np.linalg.norm(here - _fitted(there, here), axis=-1)
    return apart.reshape(count, steps, steps)


def _fitted(points: Array, target: Array) -> Array:
    """Return points (n, 3) moved and turned to lie nearest to others (W. Kabsch, 1976)."""
    middle, goal = points.mean(axis=0), target.mean(axis=0)
    left, _, right = np.linalg.svd((points - middle).T @ (target - goal))
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    return np.asarray((points - middle) @ left @ flip @ right + goal)
