"""Seams: which edges of pieces are sewn to which, and whether they are equally long."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from bodymeasure.pattern.pieces.piece import Piece, PieceEdge


@dataclass(frozen=True)
class Seam:
    """Edges that are sewn together: one on each side, or several in a row.

    Parameters
    ----------
    name : str
    sides : tuple of two tuples of (str, str)
        For each side the names of pieces and edges, in a row from one end of the seam to the other.
    lengths : tuple of (float, float)
        Of both sides in the pieces, in the atlas's unit.
    ease : float
        By how much the second side is to be longer, in the atlas's unit: what is eased or gathered
        into the seam.
    """

    name: str
    sides: tuple[tuple[tuple[str, str], ...], tuple[tuple[str, str], ...]]
    lengths: tuple[float, float]
    ease: float = 0.0

    @property
    def pieces(self) -> tuple[str, str]:
        """The names of the pieces of both sides; those in a row have a plus between them."""
        first, second = (" + ".join(piece for piece, _ in side) for side in self.sides)
        return first, second

    @property
    def edges(self) -> tuple[str, str]:
        """The names of the edges of both sides; those in a row have a plus between them."""
        first, second = (" + ".join(edge for _, edge in side) for side in self.sides)
        return first, second

    @property
    def difference(self) -> float:
        """By how much the second side is longer."""
        return self.lengths[1] - self.lengths[0]

    @property
    def excess(self) -> float:
        """By how much the second side is longer than it is to be."""
        return self.difference - self.ease


@dataclass(frozen=True)
class _End:
    """An edge with the landmarks at its ends."""

    piece: str
    edge: PieceEdge
    ends: frozenset[str]

    @property
    def names(self) -> tuple[str, str]:
        return self.piece, self.edge.name


def seams_of(pieces: Sequence[Piece]) -> Iterator[Seam]:
    """Yield the seams between pieces, in the order of the pieces.

    Edges of one seam that have both ends in common are partners, and so are an edge and several
    others that lead from one of its ends to the other. What has no such partner is held against
    the first edge of the seam.
    """
    by_name: dict[str, list[_End]] = {}
    for piece in pieces:
        through = {edge.name: edge.through for edge in piece.panel.edge}
        for edge in piece.edges:
            if edge.seam:
                marks = through[edge.name]
                ends = _End(piece.name, edge, frozenset((marks[0], marks[-1])))
                by_name.setdefault(edge.seam, []).append(ends)
    for name, every in by_name.items():
        pairs: list[tuple[list[_End], list[_End]]] = [
            ([one], [other]) for one, other in combinations(every, 2) if one.ends == other.ends
        ]
        for one in every:
            # Of three edges between three ends, the longest is sewn to both others.
            shorter = [other for other in every if other.edge.length < one.edge.length]
            row = _row(one.ends, [other for other in shorter if other.ends != one.ends])
            if row:
                pairs.append(([one], row))
        matched = {id(each) for pair in pairs for side in pair for each in side}
        lonely = [one for one in every[1:] if id(one) not in matched]
        if not lonely and len(every) > 1 and id(every[0]) not in matched:
            lonely = every[1:2]
        pairs += [([every[0]], [one]) for one in lonely]
        yield from (_seam(name, *pair) for pair in pairs)


def _row(ends: frozenset[str], others: list[_End]) -> list[_End]:
    """Return edges that lead from one end to the other in a row; none if there are none."""
    if len(ends) < 2:
        return []
    start, stop = sorted(ends)
    found: list[tuple[str, list[_End]]] = [(start, [])]
    while found:
        here, row = found.pop()
        if here == stop:
            return row
        for other in others:
            passed = frozenset().union(*(each.ends for each in row)) - {here}
            if here in other.ends and len(other.ends) == 2 and other not in row:
                (there,) = other.ends - {here}
                if there not in passed:
                    found.append((there, [*row, other]))
    return []


def _seam(name: str, first: list[_End], second: list[_End]) -> Seam:
    lengths = [sum(each.edge.length for each in side) for side in (first, second)]
    eases = [sum(each.edge.ease for each in side) for side in (first, second)]
    return Seam(
        name,
        (tuple(each.names for each in first), tuple(each.names for each in second)),
        (lengths[0], lengths[1]),
        eases[1] - eases[0],
    )
