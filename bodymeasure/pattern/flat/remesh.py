"""An even mesh of a region, with vertices at equal lengths along its edges and darts."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.pattern.curves.skin_curve import SkinCurve
from bodymeasure.pattern.cutting.region import Region
from bodymeasure.pattern.flat.locate import SkinPlaces, in_layout, on_skin
from bodymeasure.pattern.planar import shapely

# Points inside keep this part of a step from curves, so that no triangle there is much narrower
# than the others.
CLEAR = 0.62
# The least barycentric coordinate at which a dart's point still counts as inside: chains are
# straight between their points, but the skin is not.
INSIDE = -0.05
# Rounds of removing points that keep a curve from being a chain of sides.
ROUNDS = 20


@dataclass(frozen=True, eq=False)
class Outline:
    """The curves that a mesh of a region has to follow.

    Parameters
    ----------
    edges : tuple of SkinCurve
        Counterclockwise, as the region's border is.
    cuts : tuple of tuple of float
        For each edge the lengths from its start at which darts begin, in order.
    darts : tuple of SkinCurve
        From the foot to the tip, in the order of `cuts`.
    names : tuple of str
        Of the darts.
    """

    edges: tuple[SkinCurve, ...]
    cuts: tuple[tuple[float, ...], ...]
    darts: tuple[SkinCurve, ...]
    names: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Remeshed:
    """The mesh before its darts are slit.

    Parameters
    ----------
    places : SkinPlaces
    flat : ndarray, shape (n, 2)
    triangles : ndarray of int, shape (k, 3)
    edges : tuple of tuple of ndarray of int
        The vertices of each chain of each edge.
    darts : tuple of ndarray of int
    steps : tuple of tuple of ndarray
        The lengths of the sides along each chain of each edge.
    dart_steps : tuple of ndarray
    surface : tuple of ndarray, shape (n, 3), optional
        Positions and normals of the cloth where it bridges hollows; where it does not, they are
        those above the places.
    lift : ndarray, shape (n,), optional
        How far it is off there.
    """

    places: SkinPlaces
    flat: Array
    triangles: Ints
    edges: tuple[tuple[Ints, ...], ...]
    darts: tuple[Ints, ...]
    steps: tuple[tuple[Array, ...], ...]
    dart_steps: tuple[Array, ...]
    surface: tuple[Array, Array] | None = None
    lift: Array | None = None


def remeshed(region: Region, flat: Array, outline: Outline, step: float) -> Remeshed:
    """Mesh a region anew.

    Parameters
    ----------
    region : Region
    flat : ndarray, shape (n, 2)
        A layout of the region's vertices that keeps its lengths roughly.
    outline : Outline
    step : float
        The length of the sides, about.

    Raises
    ------
    InputError
        If the layout overlaps, or a dart leaves the region.
    """
    places: list[SkinPlaces] = []
    layout: list[Array] = []
    edges, steps, first = [], [], 0
    for border, curve, cuts in zip(region.border, outline.edges, outline.cuts, strict=True):
        bounds = np.array([0.0, *cuts, curve.length])
        counts = [max(1, round(length / step)) for length in np.diff(bounds)]
        arcs = np.concatenate(
            [
                low + (high - low) * np.arange(count) / count
                for low, high, count in zip(bounds[:-1], bounds[1:], counts, strict=True)
            ]
        )
        places.append(SkinPlaces(*curve.places(arcs)))
        layout.append(_along(region.positions[border], flat[border], arcs / curve.length))
        ends = first + np.cumsum([0, *counts])
        edges.append(tuple(np.arange(a, b + 1) for a, b in pairwise(ends.tolist())))
        sides = (np.diff(bounds) / counts).tolist()
        steps.append(tuple(np.full(n, side) for n, side in zip(counts, sides, strict=True)))
        first += len(arcs)
    # The last vertex of the last edge is the first one of the first.
    edges = [tuple(chain % first for chain in chains) for chains in edges]
    border_count = first
    feet = [chain[-1] for chains in edges for chain in chains[:-1]]
    darts, dart_steps = [], []
    for foot, curve, name in zip(feet, outline.darts, outline.names, strict=True):
        count = max(2, round(curve.length / step))
        inner = SkinPlaces(*curve.places(curve.length * np.arange(1, count + 1) / count))
        points, inside = in_layout(region, flat, inner)
        if inside.min() < INSIDE:
            raise InputError(
                f"dart {name!r}: it leaves the piece; make it shorter, or choose another tip"
            )
        places.append(inner)
        layout.append(points)
        darts.append(np.concatenate([[foot], np.arange(first, first + count)]))
        dart_steps.append(np.full(count, curve.length / count))
        first += count
    fixed = np.concatenate(layout)
    polygon = shapely.polygons(fixed[:border_count])
    if not shapely.is_valid(polygon):
        raise InputError(
            "its outline crosses itself when it is laid flat; cut it into smaller panels, or add a "
            "dart"
        )
    segments = np.concatenate(
        [np.stack([c[:-1], c[1:]], axis=1) for c in (*(c for e in edges for c in e), *darts)]
    )
    even = _hexagonal(polygon, fixed, segments, step)
    skin, there = on_skin(region, flat, even)
    triangles, kept = _triangulated(fixed, even[there], segments, polygon)
    even, skin = even[there][kept], skin.take(there).take(kept)
    return Remeshed(
        SkinPlaces(
            np.concatenate([*(p.patch for p in places), skin.patch]),
            np.concatenate([*(p.parameters for p in places), skin.parameters]),
        ),
        np.concatenate([fixed, even]),
        triangles,
        tuple(edges),
        tuple(darts),
        tuple(steps),
        tuple(dart_steps),
    )


def _along(positions: Array, flat: Array, part: Array) -> Array:
    """Return points of a chain in the layout at parts of its length on the skin."""
    chords = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    run = np.concatenate([[0.0], np.cumsum(chords)])
    run /= run[-1]
    return np.stack([np.interp(part, run, flat[:, axis]) for axis in range(2)], axis=1)


def _hexagonal(polygon: Any, fixed: Array, segments: Ints, step: float) -> Array:
    low, high = fixed.min(axis=0), fixed.max(axis=0)
    row = np.sqrt(0.75) * step
    y = np.arange(low[1], high[1] + row, row)
    x = np.arange(low[0] - step, high[0] + step, step)
    points = np.stack(np.meshgrid(x, y), axis=2)
    points[1::2, :, 0] += 0.5 * step
    points = points.reshape(-1, 2)
    lines = shapely.multilinestrings(list(shapely.linestrings(fixed[segments])))
    shapely.prepare(polygon)
    shapely.prepare(lines)
    dots = shapely.points(points)
    inside = shapely.contains(polygon, dots)
    inside[inside] &= ~shapely.dwithin(lines, dots[inside], CLEAR * step)
    return np.asarray(points[inside])


def _triangulated(fixed: Array, inner: Array, segments: Ints, polygon: Any) -> tuple[Ints, Ints]:
    """Return Delaunay triangles whose sides hold all segments, and the inner points kept."""
    kept = np.arange(len(inner))
    wanted = np.sort(segments, axis=1)
    for _ in range(ROUNDS):
        points = np.concatenate([fixed, inner[kept]])
        simplices = scipy.spatial.Delaunay(points).simplices.astype(np.int64)
        middles = shapely.points(points[simplices].mean(axis=1))
        triangles = simplices[shapely.contains(polygon, middles)]
        there = np.sort(
            np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2), axis=1
        )
        size = len(points)
        missing = wanted[~np.isin(wanted @ [size, 1], there @ [size, 1])]
        if not len(missing):
            break
        center = fixed[missing].mean(axis=1)
        radius = 0.5 * np.linalg.norm(np.diff(fixed[missing], axis=1)[:, 0], axis=1)
        apart = np.linalg.norm(inner[kept][:, None] - center, axis=2)
        near = (apart < 1.2 * radius).any(axis=1)
        if not near.any():
            raise InputError(
                "two of its edges, or a dart and an edge, lie too near to one another for a mesh; "
                "move them apart, or take a smaller step (of make_pattern)"
            )
        kept = kept[~near]
    else:
        raise InputError(
            "its edges are too uneven for a mesh; let them bend less, or take a smaller step (of "
            "make_pattern)"
        )
    one, other = (points[triangles[:, i]] - points[triangles[:, 0]] for i in (1, 2))
    clockwise = one[:, 0] * other[:, 1] < one[:, 1] * other[:, 0]
    triangles[clockwise] = triangles[clockwise][:, ::-1]
    return triangles, kept
