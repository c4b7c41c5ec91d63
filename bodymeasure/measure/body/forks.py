"""The points at which parts of a body fork: armpits and crotch."""

from collections.abc import Callable
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.errors import InputError
from bodymeasure.measure.body.height_saddles import saddles_between
from bodymeasure.section import Plane, PlaneSection, SectionLoop, plane_section
from bodymeasure.threads import one_blas_thread

# The number of heights at which the common stretch of two parts is cut first: some two centimeters
# apart.
LEVELS = 16
# The number of heights of a body at which loops are followed: some two centimeters apart.
FOLLOWED = 80
# The height of the fork is enclosed to within this part of the stretch before the saddle of the
# surface is looked for. Two saddles closer together than this are not distinguished.
ENCLOSED = 1e-5
# The height is moved by this part of the atlas's size where the plane touches the surface.
ASIDE = 1e-7


class _Level(NamedTuple):
    """The loops of two parts in a horizontal plane.

    Parameters
    ----------
    height : float
    loops : tuple of two SectionLoop
        The loops that hold most of the one and of the other part.
    """

    height: float
    loops: tuple[SectionLoop, SectionLoop]

    @property
    def divided(self) -> bool:
        """Whether the parts have a loop each."""
        return self.loops[0] is not self.loops[1]


@one_blas_thread()
def fork_point(atlas: Atlas, regions: tuple[str, str]) -> AtlasPoint:
    """Return the point where two parts of the body divide, going down: an armpit, the crotch.

    Parameters
    ----------
    atlas : Atlas
    regions : tuple of two str
        Beginnings of the names of regions, such as ``("torso", "upper arm left")`` or
        ``("thigh left", "thigh right")``.

    Returns
    -------
    AtlasPoint
        The saddle of the height: above, one horizontal loop goes round both parts, below, one round
        each. If several saddles of one height lie between the two loops, as to both sides of a fold
        in the middle of a symmetric body, the point of the surface midway.

    Raises
    ------
    InputError
        If there are no such regions, or no height at which the loops divide.

    Notes
    -----
    Heights are halved between one where both parts are in one loop and one where they are not.
    Where loops merge, the height has a critical point (Morse): inside a patch, where Newton's
    method finds its gradient zero and its Hessian indefinite; on a seam with a kink; or at a corner
    of patches.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> armpit = bm.fork_point(body, ("torso", "upper arm left"))
    >>> print(body.position(armpit).round(3))
    [ 0.154 -0.009  1.212]
    """
    require_atlas(atlas)
    given = regions if isinstance(regions, tuple | list) else ()
    if len(given) != 2 or not all(isinstance(name, str) for name in given):
        raise InputError(
            f"the regions are {regions!r}; expected the beginnings of two regions' names, such as "
            "('torso', 'upper arm left')"
        )
    low, high = _stretch(atlas, regions)
    # Above its regions a part still has a loop: the thighs end below the crotch on some bodies.
    heights = low + (high - low) * (np.arange(2 * LEVELS) + 0.5) / LEVELS
    enclosed = _enclosed(partial(_level, atlas, regions), heights)
    if enclosed is None:
        raise InputError(
            f"{regions[0]!r} and {regions[1]!r} have no two horizontal loops that join farther up, "
            "so that they fork nowhere; name the regions of two neighboring parts"
        )
    return _saddle(atlas, enclosed, regions)


def fork_between(atlas: Atlas, places: tuple[Location, Location]) -> AtlasPoint:
    """Return the point where the parts of the body on which two places lie divide, going down.

    It is that of `fork_point`, for atlases without regions: the parts are the horizontal loops at
    the places, followed upwards.

    Parameters
    ----------
    atlas : Atlas
    places : tuple of two str, AtlasPoint or ndarray of shape (3,)
        Places well below the fork, such as the side waist point and the elbow point for an armpit.

    Returns
    -------
    AtlasPoint

    Raises
    ------
    InputError
        If the two places lie on one loop already, or their loops join nowhere.
    """
    up = atlas.axes.up_vector
    positions = sorted((position_of(atlas, place) for place in places), key=lambda x: float(x @ up))
    low, start = (float(position @ up) for position in positions)
    extent = atlas.points @ up
    bottom, top = float(extent.min()), float(extent.max())
    # The heights are the same for both armpits of a body, so that each section is found once.
    levels = bottom + (top - bottom) * (np.arange(FOLLOWED) + 0.5) / FOLLOWED
    loop = _section(atlas, low).nearest(positions[0])
    # The lower one is followed to the height of the other.
    for height in levels[(levels > low) & (levels < start)].tolist():
        loop = _continued(_section(atlas, height), loop)
    section = _section(atlas, start)
    first = _Level(start, (_continued(section, loop), section.nearest(positions[1])))
    if not first.divided:
        raise InputError(
            "the two places are on one horizontal loop of the body; choose places farther down, "
            "on parts that are apart"
        )

    def level(height: float, below: _Level | None) -> _Level:
        section = _section(atlas, height)
        one, other = (_continued(section, each) for each in (below or first).loops)
        return _Level(height, (one, other))

    enclosed = _enclosed(level, np.append(start, levels[levels > start]))
    if enclosed is None:
        raise InputError("the horizontal loops of the two places join nowhere; choose other places")
    return _saddle(atlas, enclosed, ("the one place", "the other"))


def _saddle(atlas: Atlas, enclosed: tuple[_Level, _Level], names: tuple[str, str]) -> AtlasPoint:
    """Return the saddle of the height between two close levels."""
    above, below = enclosed
    first, second = _narrowest(*below.loops)
    middle, aside = 0.5 * (first + second), ASIDE * float(np.abs(atlas.points).max())
    found = saddles_between(atlas, below.height - aside, above.height + aside, middle)
    if not found:
        raise InputError(
            f"the loops of {names[0]!r} and {names[1]!r} divide between the heights "
            f"{below.height:.6g} and {above.height:.6g} {atlas.unit}, but the surface has no "
            "saddle there; check the atlas with bodymeasure.check_atlas"
        )
    positions = np.array([atlas.position(point) for point in found])
    twins = positions[np.linalg.norm(positions - middle, axis=1) <= np.linalg.norm(second - first)]
    if len(twins) > 1:
        return closest_points(atlas, twins.mean(axis=0)[None])[0][0]
    return found[0]


def _enclosed(
    level_at: Callable[[float, _Level | None], _Level | None], heights: Array
) -> tuple[_Level, _Level] | None:
    """Return two close levels: the parts are in one loop on the upper and in two on the lower.

    Parameters
    ----------
    level_at : callable
        Gives the level at a height, or None; it is called with the level below that is known.
    heights : ndarray
        The heights that are tried first, from below.
    """
    above: _Level | None = None
    below: _Level | None = None
    for height in heights.tolist():
        level = level_at(height, below)
        if level is None:
            continue
        if level.divided:
            below = level
        elif below is not None:
            above = level
            break
    if above is None or below is None:
        return None
    least = ENCLOSED * LEVELS * float(heights[-1] - heights[-2])
    while above.height - below.height > least:
        middle = level_at(0.5 * (above.height + below.height), below)
        if middle is None:
            break
        above, below = (above, middle) if middle.divided else (middle, below)
    return above, below


def _stretch(atlas: Atlas, regions: tuple[str, str]) -> tuple[float, float]:
    """Return the heights between which both parts lie, and between them the fork."""
    up, ends = atlas.axes.up_vector, []
    for name in regions:
        patches = [i for i, region in enumerate(atlas.regions) if region.startswith(name)]
        if not patches:
            known = ", ".join(sorted(set(atlas.regions) - {""})) or "none"
            raise InputError(
                f"the atlas has no region whose name begins with {name!r}; it has: {known}"
            )
        heights = atlas.points[atlas.index[patches]] @ up
        ends.append((float(heights.min()), float(heights.max())))
    low, high = max(end[0] for end in ends), min(end[1] for end in ends)
    if low >= high:
        raise InputError(
            f"the regions {regions[0]!r} and {regions[1]!r} share no height, so that no horizontal "
            "plane cuts both; name the regions of two neighboring parts"
        )
    return low, high


def _level(
    atlas: Atlas, regions: tuple[str, str], height: float, below: _Level | None
) -> _Level | None:
    """Return the loops at a height; None if one of the parts has none there.

    They are the loops that hold most of each region, or, above a region, the nearest ones above its
    loop below.
    """
    section = _section(atlas, height)
    loops = []
    for number, name in enumerate(regions):
        lengths = [
            sum(part for region, part in loop.length_by_region.items() if region.startswith(name))
            for loop in section.loops
        ]
        if lengths and max(lengths) > 0.0:
            loops.append(section.loops[int(np.argmax(lengths))])
        elif lengths and below is not None:
            loops.append(_continued(section, below.loops[number]))
        else:
            return None
    return _Level(height, (loops[0], loops[1]))


def _continued(section: PlaneSection, below: SectionLoop) -> SectionLoop:
    """Return the loop of a section that is nearest, on average, to one below it."""
    nearest, least = section.loops[0], np.inf
    # None is nearer than the box that holds it.
    bounds = [_apart_from_box(below.positions, loop.positions) for loop in section.loops]
    for number in np.argsort(bounds, kind="stable").tolist():
        loop = section.loops[number]
        if bounds[number] >= least:
            break
        apart = float(scipy.spatial.KDTree(loop.positions).query(below.positions)[0].mean())
        if apart < least:
            nearest, least = loop, apart
    return nearest


def _apart_from_box(positions: Array, others: Array) -> float:
    """Return the mean distance of positions from the box that holds others."""
    nearest = np.clip(positions, others.min(axis=0), others.max(axis=0))
    return float(np.linalg.norm(positions - nearest, axis=1).mean())


# Cached, since both armpits of a symmetric body are looked for at the same heights.
@lru_cache(maxsize=64)
def _section(atlas: Atlas, height: float) -> PlaneSection:
    try:
        return plane_section(atlas, Plane.horizontal(atlas, height))
    except InputError:
        # The plane touches the surface at this height.
        aside = ASIDE * float(np.abs(atlas.points).max())
        return plane_section(atlas, Plane.horizontal(atlas, height + aside))


def _narrowest(first: SectionLoop, second: SectionLoop) -> Array:
    """Return the nearest two points of two loops' samples, shape (2, 3)."""
    apart = np.linalg.norm(first.positions[:, None] - second.positions, axis=-1)
    i, j = np.unravel_index(np.argmin(apart), apart.shape)
    return np.stack([first.positions[i], second.positions[j]])
