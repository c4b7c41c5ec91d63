"""How noisy a scan is."""

import numpy as np
from scipy.sparse import csr_matrix, diags
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.solving.refined import refined
from bodymeasure.fit.solving.state import normals_at

# Vertices of the scan farther from the body, in meters, say nothing of its noise.
REACH = 0.01
# The median of the square of a normal variable, in variances.
MEDIAN = 0.4549
# The least noise that is believed, in meters: distances from tangent planes have such faults.
LEAST = 1.5e-4


def grain_of(body: Array, vertices: Array, triangles: Ints) -> tuple[float, float]:
    """Return the noise of a scan's vertices, and its variance times the area of one.

    Noise is what differs from vertex to vertex: the distance from the fitted body, less the mean
    of that of the neighbors.

    Parameters
    ----------
    body : ndarray, shape (13380, 3)
        Vertices of a body near the scan.
    vertices, triangles : ndarray, shapes (n, 3) and (m, 3)
        The scan.

    Returns
    -------
    noise : float
        Standard deviation in meters.
    grain : float
        In meters to the fourth power: a surface of the area a follows the scan, with its noise
        averaged, to the square root of ``grain / a``.
    """
    surface = refined()
    points = surface.matrix @ body
    normals = normals_at(points, surface.quads)
    distance, nearest = cKDTree(points).query(vertices, distance_upper_bound=REACH)
    near = np.isfinite(distance)
    nearest = np.where(near, nearest, 0)
    heights = np.einsum("nd,nd->n", vertices - points[nearest], normals[nearest])
    kept = near[triangles].all(axis=1)
    corners = vertices[triangles[kept]]
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    ends = triangles[kept][:, [0, 1, 1, 2, 2, 0, 1, 0, 2, 1, 0, 2]].reshape(-1, 2)
    shape = (len(vertices), len(vertices))
    beside = csr_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=shape)
    beside.data[:] = 1.0
    valence = np.asarray(beside.sum(axis=1)).ravel()
    used = valence > 2
    if not used.any():
        return LEAST, LEAST**2 * 1e-4
    mean = diags(1.0 / np.maximum(valence, 1.0)) @ (beside @ heights)
    squares = (heights - mean)[used] ** 2 / (1.0 + 1.0 / valence[used])
    noise = max(LEAST, float(np.sqrt(np.median(squares) / MEDIAN)))
    return noise, noise**2 * float(area.sum()) / int(used.sum())
