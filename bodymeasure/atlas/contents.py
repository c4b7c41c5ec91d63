"""The arrays and names that an atlas is made of, each checked before the atlas holds it."""

import unicodedata
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES, edge_table, sides_of, weights_differ
from bodymeasure.errors import InputError

# Lower degrees are written as this one without loss, so that one atlas has one degree.
LEAST_DEGREE = 3
# Polynomials of thrice this degree, as the normal of a rational patch, still have their digits.
LARGEST_DEGREE = 9


def checked_index(index: ArrayLike) -> Ints:
    """Return the control points of each patch as whole numbers that cannot be written to."""
    try:
        array = np.asarray(index)
    except ValueError:
        raise InputError(
            "the patch index is ragged; expected (patches, 4, 4): 16 control points for each "
            "bicubic patch, or the same number for patches of another degree"
        ) from None
    if array.ndim == 3 and len(array) == 0:
        raise InputError("the atlas has no patch; expected at least one")
    sides = range(LEAST_DEGREE + 1, LARGEST_DEGREE + 2)
    if array.ndim != 3 or array.shape[1] != array.shape[2] or array.shape[1] not in sides:
        raise InputError(
            f"the patch index has shape {array.shape}; expected (patches, 4, 4): 16 control points "
            f"for each bicubic patch, or as many for one degree up to {LARGEST_DEGREE}"
        )
    if array.dtype.kind not in "iu":
        raise InputError(f"the patch index holds {array.dtype}; expected whole numbers")
    array = array.astype(np.int64)
    array.flags.writeable = False
    return array


def checked_points(points: ArrayLike, index: Ints, names: tuple[str, ...]) -> Array:
    """Return finite control points, of which every patch has its own by their number."""
    try:
        array = np.array(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("control points are not numbers; expected an array of (n, 3)") from None
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"control points have shape {array.shape}; expected (n, 3)")
    outside = (index < 0) | (index >= len(array))
    if outside.any():
        patch = int(np.flatnonzero(outside.any(axis=(1, 2)))[0])
        number = int(index[patch][outside[patch]][0])
        called = f" ({names[patch]!r})" if patch < len(names) else ""
        raise InputError(
            f"patch {patch}{called} refers to control point {number}, but the points are numbered "
            f"0 to {len(array) - 1}"
        )
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad):
        raise InputError(
            f"control point {bad[0]} is {array[bad[0]].tolist()}; expected finite coordinates "
            f"({len(bad)} such point{'s' if len(bad) > 1 else ''})"
        )
    array.flags.writeable = False
    return array


def checked_weights(weights: ArrayLike, index: Ints) -> Array:
    """Return positive weights of control points that agree where patches meet."""
    try:
        array = np.array(weights, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("weights are not numbers; expected one for each control point") from None
    if array.shape != index.shape:
        raise InputError(f"weights have shape {array.shape}; expected that of index, {index.shape}")
    # `not positive` rather than `negative`, so that NaN is refused too.
    bad = np.argwhere(~((array > 0.0) & (array < np.inf)))
    if len(bad):
        patch, i, j = bad[0].tolist()
        raise InputError(
            f"patch {patch} has the weight {array[patch, i, j]:g}; expected positive weights, with "
            "which a patch has no poles"
        )
    _check_weights_of_seams(index, array)
    array.flags.writeable = False
    return array


def _check_weights_of_seams(index: Ints, weights: Array) -> None:
    table = edge_table(index)
    along = sides_of(weights)
    along = np.where(table.reversed[..., None], along[..., ::-1], along)
    along = along.reshape(-1, along.shape[-1])
    _, first = np.unique(table.edge, return_index=True)
    differ = weights_differ(along, along[first[table.edge.ravel()]])
    bad = np.flatnonzero(differ & ~table.collapsed.ravel())
    if len(bad):
        patches = first[table.edge.ravel()[bad[0]]] // len(EDGES), bad[0] // len(EDGES)
        raise InputError(
            f"patches {patches[0]} and {patches[1]} share the control points of an edge, but not "
            "the ratios of its weights, so that points with equal parameters on it differ; give "
            "both the same weights there"
        )


def check_names(
    count: int,
    patch_names: Sequence[str],
    regions: Sequence[str],
    landmarks: Mapping[str, AtlasPoint],
) -> None:
    """Refuse names that do not tell patches apart, and landmarks outside of the patches.

    Parameters
    ----------
    count : int
        The number of patches.

    Raises
    ------
    InputError
        Which name or landmark it is, and what was expected.
    """
    for what, names in (("patch names", patch_names), ("regions", regions)):
        if len(names) != count:
            raise InputError(f"{len(names)} {what} for {count} patches; expected one each")
    seen: set[str] = set()
    for name in patch_names:
        if not name.strip() or any(unicodedata.category(sign) == "Cc" for sign in name):
            raise InputError(
                f"a patch is named {name!r}; expected a name on one line, without control "
                "characters"
            )
        if name in seen:
            raise InputError(f"two patches are named {name!r}; patch names must be unique")
        seen.add(name)
    for name, point in landmarks.items():
        if not 0 <= point.patch < count:
            raise InputError(
                f"landmark {name!r} lies on patch {point.patch}, but the patches are numbered "
                f"0 to {count - 1}"
            )
        if not (0.0 <= point.u <= 1.0 and 0.0 <= point.v <= 1.0):
            raise InputError(
                f"landmark {name!r} has (u, v) = ({point.u}, {point.v}); expected both in [0, 1]"
            )
