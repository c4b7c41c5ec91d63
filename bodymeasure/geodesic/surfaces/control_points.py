"""Control points as users give them: checked once, and scaled to size 1."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import array_api_compat
import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import project
from bodymeasure.errors import InputError
from bodymeasure.geodesic.numerics.array_libraries import constant, namespace, to_numpy
from bodymeasure.native import extents as compiled_extents
from bodymeasure.native import is_compiled

# Coordinates beyond this could overflow in a length.
LARGEST = 1e300
# The largest exponent of a power of 2 that can be multiplied with anything near 1.
MOST = 1000


class Prepared(NamedTuple):
    """Control points as they are solved with.

    Parameters
    ----------
    nets : array, shape (patches, m + 1, n + 1, c)
        Patches of about size 1.
    sizes : ndarray, shape (patches,)
        What they were divided by.
    batch : tuple of int
        The shape of the batch of patches as the user gave it.
    """

    nets: Any
    sizes: Array
    batch: tuple[int, ...]


def prepared_control_points(value: Any) -> Prepared:
    """Return control points as an array of 64-bit numbers, checked and scaled to size 1.

    Parameters
    ----------
    value : array_like, shape (..., m + 1, n + 1, 3), or 4 for rational patches
        Arrays of other libraries than numpy (torch, CuPy, JAX) stay what and where they are.

    Raises
    ------
    InputError
        If a shape or value is wrong, or a patch is collapsed to a point.
    """
    nets = _as_array(value)
    shape = tuple(nets.shape)
    if len(shape) < 3 or shape[-1] not in (3, 4) or min(shape[-3:-1]) < 2:
        raise InputError(
            f"control points have shape {shape}; expected (..., m + 1, n + 1, 3), "
            "such as (4, 4, 3) for one bicubic patch, or 4 coordinates for rational ones"
        )
    if shape[-1] == 4:
        nets = _with_weights(nets)
    nets, sizes, extent, largest = _of_size_one(nets.reshape((-1, *shape[-3:])))
    # `not good` rather than `bad`, so that NaN is refused too.
    if not ((largest <= LARGEST) & (extent > 0.0)).all():
        raise InputError(_fault(extent, largest))
    return Prepared(nets, sizes, shape[:-3])


def _fault(extent: Array, largest: Array) -> str:
    """What is wrong with the first patch that is not accepted."""
    bad = np.flatnonzero(~np.isfinite(largest))
    if len(bad):
        return f"patch {bad[0]} has control points that are not finite; correct them"
    huge = np.flatnonzero(largest > LARGEST)
    if len(huge):
        return (
            f"patch {huge[0]} has coordinates of {largest[huge[0]]:.3g}; expected at most "
            f"{LARGEST:g}: choose a larger unit"
        )
    collapsed = np.flatnonzero(extent == 0.0)[0]
    return f"patch {collapsed} is degenerate: all its control points are equal; remove it"


def _with_weights(nets: Any) -> Array:
    """Rational patches as an array of numpy's, once their weights are known to be positive."""
    array = to_numpy(nets)
    weights = array[..., 3].reshape(-1, array.shape[-3] * array.shape[-2])
    # `not positive` rather than `negative`, so that NaN is refused too.
    bad = np.flatnonzero(~((weights > 0.0) & (weights < np.inf)).all(axis=1))
    if len(bad):
        raise InputError(
            f"patch {bad[0]} has a weight of {weights[bad[0]].min():g}; expected positive weights, "
            "with which a patch has no poles"
        )
    return array


def _as_array(value: Any) -> Any:
    foreign = not isinstance(value, np.ndarray) and array_api_compat.is_array_api_obj(value)
    try:
        if foreign:
            return _as_doubles(value)
        if np.iscomplexobj(value):
            raise TypeError
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(
            f"a surface of type {type(value).__name__} is neither an array of real numbers nor "
            "an object with a method `derivatives`; expected one of them, such as an atlas's "
            "`control_points`"
        ) from None


def _as_doubles(value: Any) -> Any:
    xp = namespace(value)
    if xp.isdtype(value.dtype, "complex floating"):
        raise TypeError
    # A torch tensor may record what is done with it; only its numbers are wanted.
    value = value.detach() if hasattr(value, "detach") else value
    return xp.astype(value, xp.float64, copy=False)


def collapsed_patches(control_points: Any) -> Ints:
    """Return the numbers of the patches, shape (..., m + 1, n + 1, 3), whose points are equal."""
    return np.flatnonzero(extents(control_points)[0] == 0.0)


def of_size_one(nets: Any) -> tuple[Any, Array]:
    """Return patches scaled to about size 1, so that tolerances mean the same, and their sizes.

    The sizes are powers of 2, so that nothing is rounded.
    """
    return _of_size_one(nets)[:2]


def _of_size_one(nets: Any) -> tuple[Any, Array, Array, Array]:
    """The scaled patches, their sizes, and their `extents`."""
    if _serves(nets):
        scaled = np.empty(nets.shape)
        points = nets.reshape((len(nets), math.prod(nets.shape[1:-1]), 3))
        extent, largest, sizes = compiled_extents(points, scaled)
        return scaled, sizes, extent, largest
    extent, largest = extents(nets)
    power = np.frexp(extent)[1] - 1
    # The smallest patches are scaled twice, since their factors are beyond the largest number.
    first = np.maximum(power, -MOST)
    nets = _scaled(nets, first)
    if (power < first).any():
        nets = _scaled(nets, power - first)
    return nets, np.ldexp(1.0, power), extent, largest


def _serves(points: Any) -> bool:
    """Whether there is a kernel for points."""
    return isinstance(points, np.ndarray) and points.shape[-1] == 3 and is_compiled()


def _scaled(nets: Any, power: Ints) -> Any:
    """The patches divided by powers of 2, with these exponents."""
    xp, size = namespace(nets), math.prod(nets.shape[1:])
    # One factor for whole rows takes a third of the time of three that alternate.
    factor = np.ldexp(1.0, -power)[:, None]
    if nets.shape[-1] == 4:
        # Weights have no unit.
        factor = np.tile(
            np.append(np.repeat(factor, 3, axis=1), np.ones_like(factor), axis=1), size // 4
        )
    flat = xp.reshape(nets, (nets.shape[0], size)) * constant(factor, nets, xp)
    return xp.reshape(flat, nets.shape)


def extents(control_points: Any) -> tuple[Array, Array]:
    """Return the greatest extent of each patch along an axis, and its largest coordinate.

    Both have shape (patches,), and are not finite where a coordinate is not.
    """
    if control_points.shape[-1] == 4:
        control_points = project(control_points)
    xp = namespace(control_points)
    points = xp.reshape(control_points, (-1, math.prod(control_points.shape[-3:-1]), 3))
    if _serves(points):
        extent, largest = compiled_extents(points)
        return extent, largest
    low, high = (to_numpy(_folded(points, each)) for each in (xp.minimum, xp.maximum))
    with np.errstate(over="ignore", invalid="ignore"):
        return _largest(high - low), _largest(np.maximum(-low, high))


def _largest(values: Array) -> Array:
    """The largest of three numbers, of each patch: by columns, which takes a fifth of the time."""
    result: Array = np.maximum(np.maximum(values[:, 0], values[:, 1]), values[:, 2])
    return result


def _folded(points: Any, operation: Callable[[Any, Any], Any]) -> Any:
    """A reduction along axis 1 by halves laid over one another, ten times as fast as others."""
    while points.shape[1] > 1:
        half = (points.shape[1] + 1) // 2
        points = operation(points[:, :half, :], points[:, -half:, :])
    return points[:, 0, :]
