"""How long a level line across a piece is on the cloth itself, between the vertices of its mesh."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.cutting.region import Region
from bodymeasure.pattern.flat.level_line import LevelLine
from bodymeasure.pattern.flat.locate import SkinPlaces, in_layout, triangles_at
from bodymeasure.pattern.flat.mesh import PieceMesh
from bodymeasure.section import Plane, SectionLoop, plane_section

# In meters: the chords of the line on the cloth, which in a crease bends within a side of the mesh.
CHORD = 0.0005
# Halvings of a chord that find where it leaves the piece, to a part in a million.
HALVINGS = 20
# The part of a gap's cloth that is lifted where it bridges the gap. Near its ends, the tension
# along the body may hold the cloth on the skin; where the piece ends in it, little is lifted.
BRIDGED = 0.25
# Chords of a loop round which a tape can go.
FEWEST = 4
# Barycentric coordinates that are negative by no more than this are 0: the line may run along sides
# of the region's triangles.
ROUNDING = 1e-9


class _Chords(NamedTuple):
    """Chords of the section of the skin: the ends (k, n + 1, 2) of those on each patch (k,)."""

    patch: Ints
    ends: Array

    @property
    def places(self) -> SkinPlaces:
        """The ends of all chords, in a row."""
        return SkinPlaces(np.repeat(self.patch, self.ends.shape[1]), self.ends.reshape(-1, 2))


def length_on_cloth(
    cloth: Cloth, cut: tuple[Region, Array], mesh: PieceMesh, line: LevelLine, plane: Plane
) -> float:
    """Return the length of the cloth's line above the section of the skin by a level plane.

    A mesh cuts short where the skin has a crease, as between breasts. Where the cloth bridges
    hollows of the section, the line is taut, as a tape is. Where it is lifted elsewhere, it is
    straight enough for the line of the mesh to serve.

    Parameters
    ----------
    cloth : Cloth
    cut : tuple of Region and ndarray, shape (n, 2)
        The region of the piece, and its vertices in the layout in which the mesh was made.
    mesh : PieceMesh
    line : LevelLine
        The line in that mesh.
    plane : Plane
        Of the level.
    """
    lifted = np.asarray((mesh.lift[mesh.triangles] > 0.0).any(axis=1), dtype=np.bool_)
    total = 0.0
    for loop in plane_section(cloth.atlas, plane).loops:
        chords = _chords(loop, cut[0], CHORD / cloth.atlas.unit.meters)
        if chords is None:
            continue
        points = cloth.positions(*chords.places).reshape(*chords.ends.shape[:2], 3)
        lengths = np.linalg.norm(np.diff(points, axis=1), axis=2)
        parts = _parts_inside(cut, chords)
        if lifted.any():
            middles = 0.5 * (chords.ends[:, 1:] + chords.ends[:, :-1])
            at, _ = in_layout(*cut, _Chords(chords.patch, middles).places)
            triangle = triangles_at(mesh.start[mesh.triangles], at).reshape(parts.shape)
            off = (triangle >= 0) & lifted[triangle]
            taut = _taut(points, plane.normal) if loop.closed else None
            if taut is not None:
                bridged = _bridged(taut.gap, parts * lengths, off)
                lengths = np.where(bridged, taut.lengths, lengths)
                lifted[triangle[bridged & off]] = False
                off &= ~bridged
            parts[off] = 0.0
        total += float((parts * lengths).sum())
    return total + float(line.lengths[lifted[line.triangles]].sum())


class _Taut(NamedTuple):
    """What chords (k, n) of a loop add to the tape round it, and the gaps that it spans there."""

    lengths: Array
    gap: Ints


def _taut(points: Array, normal: Array) -> _Taut | None:
    """Return a tape round a closed loop of chords (k, n + 1, 3) in a plane; None if it has none.

    Between two places where it touches, a chord adds by how much it advances from one to the other.
    """
    axes = np.linalg.svd(normal[None])[2][1:]
    flat = points[:, :-1].reshape(-1, 3) @ axes.T
    if len(flat) < FEWEST:
        return None
    touching = np.sort(scipy.spatial.ConvexHull(flat).vertices)
    gap = np.searchsorted(touching, np.arange(len(flat)), side="right") - 1
    ways = np.roll(flat[touching], -1, axis=0) - flat[touching]
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    steps = np.diff(points, axis=1).reshape(-1, 3) @ axes.T
    shape = points.shape[0], points.shape[1] - 1
    # What comes before the first of these places is in the last gap.
    lengths = (steps * ways[gap]).sum(axis=1)
    return _Taut(lengths.reshape(shape), (gap % len(touching)).reshape(shape))


def _bridged(gap: Ints, lengths: Array, off: Bools) -> Bools:
    """Return which chords are in gaps that the cloth bridges, by how much of it is lifted there."""
    number = gap.ravel()
    whole = np.bincount(number, weights=lengths.ravel())
    free = np.bincount(number, weights=(lengths * off).ravel())
    return np.asarray((free > BRIDGED * whole)[gap])


def _chords(loop: SectionLoop, region: Region, length: float) -> _Chords | None:
    """Return a loop's chords; None if it has none on the patches of a region."""
    if not np.isin(loop.pieces.patch, region.patch).any():
        return None
    count = max(2, int(np.ceil(float(loop.piece_length.max()) / length)))
    steps = np.broadcast_to(np.arange(count + 1) / count, (loop.count, count + 1))
    return _Chords(loop.pieces.patch, loop.surface.parameters(loop.pieces, steps))


def _parts_inside(cut: tuple[Region, Array], chords: _Chords) -> Array:
    """Return the part of each chord that lies in a region, shape (k, n)."""

    def is_inside(places: SkinPlaces) -> Bools:
        return np.asarray(in_layout(*cut, places)[1] >= -ROUNDING)

    inside = is_inside(chords.places).reshape(chords.ends.shape[:2])
    start, stop = inside[:, :-1], inside[:, 1:]
    result = (start & stop).astype(np.float64)
    row, column = np.nonzero(start != stop)
    first, last = chords.ends[row, column], chords.ends[row, column + 1]
    begins = inside[row, column]
    low, high = np.zeros(len(row)), np.ones(len(row))
    for _ in range(HALVINGS if len(row) else 0):
        middle = 0.5 * (low + high)
        at = first + middle[:, None] * (last - first)
        same = is_inside(SkinPlaces(chords.patch[row], at)) == begins
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    result[row, column] = np.where(begins, low, 1.0 - low)
    return result
