"""How long a level line across a piece is on the cloth itself, between the vertices of its mesh."""

from typing import NamedTuple

import numpy as np

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

    A mesh cuts short where the skin has a crease, as between breasts. Where the cloth is lifted
    from the skin, it is straight enough for the line of the mesh to serve.

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
    total = float(line.lengths[lifted[line.triangles]].sum())
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
            parts[(triangle >= 0) & lifted[triangle]] = 0.0
        total += float((parts * lengths).sum())
    return total


def _chords(loop: SectionLoop, region: Region, length: float) -> _Chords | None:
    """Return a loop's chords on the patches of a region; None if it has none there."""
    rows = np.flatnonzero(np.isin(loop.pieces.patch, region.patch))
    if not len(rows):
        return None
    count = max(2, int(np.ceil(float(loop.piece_length[rows].max()) / length)))
    pieces = loop.pieces.take(rows)
    steps = np.broadcast_to(np.arange(count + 1) / count, (len(rows), count + 1))
    return _Chords(pieces.patch, loop.surface.parameters(pieces, steps))


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
