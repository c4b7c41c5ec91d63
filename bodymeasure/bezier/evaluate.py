"""Points and derivatives of Bezier patches."""

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.bezier.bernstein import bernstein
from bodymeasure.bezier.rational import divide


def evaluate(control_points: ArrayLike, parameters: ArrayLike) -> Array:
    """Return the points S(u, v) of Bezier patches.

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
        Those of rational patches have a last axis of 4 (see `homogeneous`).
    parameters : array_like, shape (*batch, ..., 2)
        (u, v) pairs; their leading axes must broadcast with the patches' batch axes.

    Returns
    -------
    ndarray, shape (*batch, ..., 3)
    """
    return derivatives(control_points, parameters, order=0)[..., 0, 0, :]


def derivatives(control_points: ArrayLike, parameters: ArrayLike, order: int) -> Array:
    """Return the partial derivatives of Bezier patches.

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
        Those of rational patches have a last axis of 4 (see `homogeneous`).
    parameters : array_like, shape (*batch, ..., 2)
        (u, v) pairs; their leading axes must broadcast with the patches' batch axes.
    order : int
        Highest derivative in each of u and v.

    Returns
    -------
    ndarray, shape (*batch, ..., order + 1, order + 1, 3)
        ``[..., i, j, :]`` is the derivative taken i times by u and j times by v.

    Examples
    --------
    >>> import numpy as np
    >>> plane = np.stack(np.meshgrid([0, 1, 2, 3], [0, 1, 2, 3], [0], indexing="ij"), -1)[:, :, 0]
    >>> derivatives(plane, [0.5, 0.25], order=1)[1, 0]
    array([3., 0., 0.])
    """
    net = np.asarray(control_points, dtype=np.float64)
    parameters = np.asarray(parameters, dtype=np.float64)
    batch = net.ndim - 3
    points_axes = parameters.ndim - 1 - batch
    if points_axes < 0:
        raise ValueError(
            f"parameters of shape {parameters.shape} do not lead with the {batch} batch axes "
            f"of control points of shape {net.shape}"
        )
    basis_u = bernstein(net.shape[-3] - 1, parameters[..., 0], order)
    basis_v = bernstein(net.shape[-2] - 1, parameters[..., 1], order)
    # One axis per point axis between the batch axes and the net.
    net = net.reshape(*net.shape[:batch], *(1,) * points_axes, *net.shape[batch:])
    along_u = np.einsum("...ai,...ijc->...ajc", basis_u, net)
    result = np.asarray(basis_v[..., None, :, :] @ along_u)
    return divide(result) if net.shape[-1] == 4 else result
