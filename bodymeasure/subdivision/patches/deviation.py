"""The deviation of patches from the Catmull-Clark surface that they approximate."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.subdivision.patches.grid import grid_jets
from bodymeasure.subdivision.patches.irregular import irregular_quads, neighborhood, subdivided
from bodymeasure.subdivision.patches.loop_schaefer import PatchNets, loop_schaefer
from bodymeasure.subdivision.patches.projection import closest_on_patches, unit
from bodymeasure.subdivision.polygon_mesh import PolygonMesh

# Steps of subdivision after which patches stand for the surface: they are exact but for those at
# irregular vertices, whose deviation at least halves with each step.
STEPS = 2
# With more quads to compare, one step has to do.
MANY = 2000
# Quads that are compared at once, so that memory stays within some 100 MB.
BLOCK = 500
# Places on each finer patch, in u and in v: the nodes of Gauss's rule.
NODES = 0.5 + np.sqrt(1.0 / 12.0) * np.array([-1.0, 1.0])
# A slope beyond this is none of a small deviation; lengths may be wrong by any part then.
STEEP = 0.99
# The least square of the sine between tangents, and the least number to divide by.
PARALLEL = 1e-12
SMALLEST = 1e-150


class Deviation(NamedTuple):
    """The deviation of patches from a surface.

    Parameters
    ----------
    distance : ndarray, shape (patches,)
        The largest distance of each patch from the surface, along its normal.
    stretch : ndarray, shape (patches,)
        A bound on the relative difference of lengths on the patch and on the surface, at most 1.
    """

    distance: Array
    stretch: Array


def limit_deviation(mesh: PolygonMesh, nets: PatchNets) -> Deviation:
    """Return the deviation of patches from the Catmull-Clark surface of their mesh.

    Parameters
    ----------
    mesh : PolygonMesh
        A mesh of quads alone.
    nets : PatchNets
        Its patches, by `loop_schaefer`.

    Returns
    -------
    Deviation
        It is 0 where the patch is the surface itself.

    Notes
    -----
    A displacement d along the normal of a surface changes the length of a curve on it by the factor
    ``1 - d k``, with k the curvature in the direction of the curve, and a slope of the displaced
    surface against the first by at most ``1 / cos``: the stretch is the largest ``|d| |k| + 1 / cos
    - 1`` on the patch, with the larger of the principal curvatures. If it is s everywhere, shortest
    distances on the two surfaces differ by at most that factor, because the metrics do.

    What the finer patches lack themselves is added, as a geometric series.
    """
    count = len(mesh.sizes)
    result = Deviation(np.zeros(count), np.zeros(count))
    irregular = irregular_quads(mesh)
    numbers = np.flatnonzero(irregular)
    if not len(numbers):
        return result
    steps = STEPS if len(numbers) <= MANY else 1
    rest = 1.0 / (1.0 - 0.5**steps)
    fine, children, places = subdivided(*neighborhood(mesh, irregular), steps)
    finer = loop_schaefer(fine)
    parameters = _parameters(places)
    for first in range(0, len(numbers), BLOCK):
        some = slice(first, first + BLOCK)
        coarse = nets.points[nets.index[numbers[some]]]
        truth = finer.points[finer.index[children[some]]]
        distance, stretch = _compare(coarse, truth, parameters)
        result.distance[numbers[some]] = rest * distance.max(axis=1)
        result.stretch[numbers[some]] = np.minimum(rest * stretch.max(axis=1), 1.0)
    return result


def _parameters(places: Array) -> Array:
    """The parameters of the nodes of finer patches on the coarse one, shape (nodes, 2)."""
    s, t = (each.ravel()[:, None] for each in np.meshgrid(NODES, NODES, indexing="ij"))
    begin, along, up = places[:, None, 0], places[:, None, 1], places[:, None, 3]
    return np.asarray(begin + s * (along - begin) + t * (up - begin)).reshape(-1, 2)


def _compare(coarse: Array, truth: Array, parameters: Array) -> tuple[Array, Array]:
    """Distances and stretches at the nodes on each patch, shape (patches, nodes)."""
    jets = grid_jets(truth, NODES, 2).reshape(len(coarse), -1, 3, 3, 3)
    start = np.broadcast_to(parameters, (*jets.shape[:2], 2))
    offsets, normals = closest_on_patches(coarse, jets[..., 0, 0, :], start)
    distance = np.linalg.norm(offsets, axis=-1)
    normal, curvature = _curvature(jets)
    sine = np.minimum(np.linalg.norm(np.cross(normal, normals), axis=-1), STEEP)
    bent = np.minimum(distance, 1.0 / np.maximum(curvature, SMALLEST)) * curvature
    return distance, bent + 1.0 / np.sqrt(1.0 - sine**2) - 1.0


def _curvature(jets: Array) -> tuple[Array, Array]:
    """Unit normals, and the larger of the two principal curvatures' sizes."""
    su, sv = jets[..., 1, 0, :], jets[..., 0, 1, :]
    normal = unit(np.cross(su, sv))
    first = [np.einsum("...c,...c->...", *each) for each in ((su, su), (su, sv), (sv, sv))]
    second = [
        np.einsum("...c,...c->...", jets[..., i, j, :], normal) for i, j in ((2, 0), (1, 1), (0, 2))
    ]
    (e, f, g), (l, m, n) = first, second  # noqa: E741
    # Where the tangents are parallel, the curvature is as large as it gets.
    area = np.maximum(e * g - f * f, PARALLEL * e * g) + SMALLEST
    mean = 0.5 * (e * n - 2.0 * f * m + g * l) / area
    gauss = (l * n - m * m) / area
    return normal, np.abs(mean) + np.sqrt(np.maximum(mean**2 - gauss, 0.0))
