"""Parts of paths over an atlas: pieces in order, and the seams that are crossed between them."""

from collections.abc import Sequence
from dataclasses import dataclass

from bodymeasure._typing import Array
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.spaces.trial_space import TrialSpace


@dataclass(frozen=True, eq=False)
class PathPiece:
    """The part of a path that runs over one patch.

    Parameters
    ----------
    patch : int
    space : TrialSpace
    values : ndarray, shape (2, n + 1)
        u and v at the space's nodes.
    length : float
        In the atlas's unit.
    """

    patch: int
    space: TrialSpace
    values: Array
    length: float

    def end(self, node: int) -> AtlasPoint:
        """Return the point at the first node (0) or at the last one (-1)."""
        return AtlasPoint(self.patch, *self.values[:, node].tolist())


@dataclass(frozen=True, eq=False)
class PathPart:
    """A path or a loop, or a part of one.

    Parameters
    ----------
    pieces : tuple of PathPiece
    crossings : tuple of (int, AtlasPoint, AtlasPoint)
        For each seam that is crossed the number of the piece before it, which is -1 for the first
        crossing of a loop, and the point there on both patches.
    length : Length
        In the atlas's unit.
    """

    pieces: tuple[PathPiece, ...]
    crossings: tuple[tuple[int, AtlasPoint, AtlasPoint], ...]
    length: Length

    @classmethod
    def of(cls, refined: RefinedPath, length: Length) -> "PathPart":
        """Return a path that was refined."""
        route, space = refined.route, refined.problem.space
        lengths = (refined.lengths * refined.problem.size).tolist()
        parts = zip(route.patches, refined.values, lengths, strict=True)
        return cls(
            tuple(PathPiece(patch, space, values, piece) for patch, values, piece in parts),
            tuple(
                (n - route.closed, *points)
                for n, (points, crossing) in enumerate(
                    zip(route.crossed, route.crossings, strict=True)
                )
                if crossing.within is None
            ),
            length,
        )

    @classmethod
    def joined(cls, parts: "Sequence[PathPart]") -> "PathPart":
        """Return several parts as one; those of no length are left out."""
        parts = [part for part in parts if part.length.raw > 0.0]
        pieces: list[PathPiece] = []
        crossings: list[tuple[int, AtlasPoint, AtlasPoint]] = []
        for part in parts:
            if pieces and pieces[-1].patch != part.pieces[0].patch:
                crossings.append((len(pieces) - 1, pieces[-1].end(-1), part.pieces[0].end(0)))
            crossings += [
                (len(pieces) + number, before, after) for number, before, after in part.crossings
            ]
            pieces += part.pieces
        return cls(
            tuple(pieces), tuple(crossings), Length.of_parts([part.length for part in parts])
        )
