"""Points that users name, as points of an atlas and as positions."""

import operator
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas, require_atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.atlas.units import Unit
from bodymeasure.errors import InputError

Location = str | AtlasPoint | Sequence[float] | Array
"""A landmark's name, a point of the atlas, or a position (x, y, z) in the atlas's unit."""

# Part of a surface's size: a position that is farther from it does not lie on it, or is in another
# unit.
FARTHEST = 0.02


def atlas_point(atlas: Atlas, location: Location, name: str = "the point") -> AtlasPoint:
    """Return the point of an atlas at a location.

    Parameters
    ----------
    atlas : Atlas
    location : Location
        The name of a landmark, a point of the atlas, or a position of shape (3,) in the atlas's
        unit, for which the closest point is taken.
    name : str
        What an error's message calls the location.

    Raises
    ------
    InputError
        If the atlas has no such landmark (the message suggests the nearest name) or no such point,
        or if the position is farther from the surface than `FARTHEST` times its size.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> atlas = bm.load_sample("paraboloid")
    >>> atlas_point(atlas, (0.0, 0.0, 0.0))
    AtlasPoint(patch=0, u=0.0, v=0.0)
    """
    require_atlas(atlas)
    if isinstance(location, str):
        return atlas.landmark(location)
    if isinstance(location, AtlasPoint):
        return _checked(atlas, location, name)
    points, _ = points_near(atlas, [_position(location, name)], [name])
    return points[0]


def listed(locations: Sequence[Location], name: str) -> tuple[Location, ...]:
    """Return several locations, once it is known that they are several.

    Raises
    ------
    InputError
        If they are a single name or point, or no sequence at all.
    """
    if isinstance(locations, (str, AtlasPoint)) or not isinstance(locations, Iterable):
        raise InputError(f"{name} is {locations!r}; expected a list of locations")
    return tuple(locations)


def position_of(atlas: Atlas, location: Location, name: str = "the point") -> Array:
    """Return the position of a location, shape (3,), in the atlas's unit.

    A position is returned as it is: it may lie inside of a body, whose girth there is wanted.

    Raises
    ------
    InputError
        If the atlas has no such landmark or point, or the position is not three finite numbers.
    """
    require_atlas(atlas)
    if isinstance(location, (str, AtlasPoint)):
        return atlas.position(atlas_point(atlas, location, name))
    return _position(location, name)


def points_near(
    atlas: Atlas,
    positions: ArrayLike,
    names: Sequence[str],
    *,
    unit: Unit | None = None,
    farthest: float | None = None,
    remedy: str = "",
) -> tuple[tuple[AtlasPoint, ...], Array]:
    """Return the closest points to positions that must lie near the atlas.

    Parameters
    ----------
    atlas : Atlas
    positions : array_like, shape (k, 3)
    names : sequence of str, length k
        What an error's message calls each position.
    unit : Unit, optional
        The unit of the positions; the atlas's, if none is given.
    farthest : float, optional
        The largest distance allowed, in the atlas's unit; by default `FARTHEST` times the size of
        the atlas.
    remedy : str
        What else an error's message says about a position that is too far away.

    Returns
    -------
    points : tuple of AtlasPoint, length k
    distances : ndarray, shape (k,)
        In the atlas's unit.

    Raises
    ------
    InputError
        If a position is not finite, or too far from the surface; the message names the unit in
        which it would be near enough, if there is one.
    """
    given = np.asarray(positions, dtype=np.float64)
    for position, name in zip(given, names, strict=True):
        _position(position, name)
    unit = unit or atlas.unit
    scale = unit.meters / atlas.unit.meters
    points, distances = closest_points(atlas, given * scale)
    limit = FARTHEST * float(np.ptp(atlas.points, axis=0).max()) if farthest is None else farthest
    too_far = np.flatnonzero(distances > limit)
    if len(too_far):
        row = int(too_far[0])
        said = far_words(
            names[row], given[row], distances[row] / scale, limit / scale, unit=unit.value
        )
        raise InputError(f"{said}; {_unit_hint(atlas, given[row], unit, limit)}{remedy}")
    return points, distances


def far_words(
    name: str,
    position: Array,
    distance: float,
    limit: float,
    *,
    unit: str = "",
    surface: str = "the surface",
) -> str:
    """Say how far a position is from a surface, and how far it may be, all in one unit."""
    where, after = ", ".join(f"{x:g}" for x in position), f" {unit}".rstrip()
    return (
        f"{name} at ({where}){after} is {distance:.4g}{after} from {surface}, more than "
        f"{limit:.4g}{after}"
    )


def _unit_hint(atlas: Atlas, position: Array, unit: Unit, limit: float) -> str:
    """Return advice on a position that is too far from the atlas."""
    others = [other for other in Unit if other is not unit]
    scales = np.array([other.meters / atlas.unit.meters for other in others])
    _, distances = closest_points(atlas, position * scales[:, None])
    best = int(np.argmin(distances))
    if distances[best] > limit:
        return "check its coordinates, its unit, and that it is in the atlas's axes"
    apart = f"{distances[best] / scales[best]:.2g} {others[best]}"
    return f"in {others[best]} it would be {apart} from it: check the unit"


def _position(location: ArrayLike, name: str) -> Array:
    try:
        position = np.asarray(location, dtype=np.float64)
    except (TypeError, ValueError):
        position = np.empty(0)
    if position.shape != (3,) or not np.isfinite(position).all():
        raise InputError(
            f"{name} is {_shown(location)}; expected three finite numbers, a landmark's name or an "
            "AtlasPoint"
        )
    return position


def _shown(location: ArrayLike) -> str:
    return repr(location.tolist() if isinstance(location, np.ndarray) else location)


def _checked(atlas: Atlas, point: AtlasPoint, name: str) -> AtlasPoint:
    """Return a point in plain numbers, once it is known to be on the atlas."""
    try:
        patch, u, v = operator.index(point.patch), float(point.u), float(point.v)
    except (TypeError, ValueError):
        raise InputError(
            f"{name} is {point}; expected the number of a patch, and u and v in [0, 1]"
        ) from None
    if not 0 <= patch < len(atlas):
        raise InputError(
            f"{name} is on patch {patch}, but the patches are numbered 0 to {len(atlas) - 1}"
        )
    # `not inside` rather than `outside`, so that NaN is refused too.
    if not (0.0 <= u <= 1.0 and 0.0 <= v <= 1.0):
        raise InputError(f"{name} has (u, v) = ({u}, {v}); expected both in [0, 1]")
    return AtlasPoint(patch, u, v)
