"""A closed curve of arcs of a section, joined by straight lines."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.part import joined
from bodymeasure.section.pieces import MORE_NODES
from bodymeasure.section.plane import Plane


@dataclass(frozen=True, eq=False)
class BridgedLoop:
    """Arcs in order, each joined by a straight line to the next, and the last one to the first.

    It is a `Curve`: each line is a piece like those of the arcs.

    Parameters
    ----------
    arcs : tuple of SectionLoop
        Open curves of one section.
    """

    arcs: tuple[SectionLoop, ...]

    @property
    def plane(self) -> Plane:
        """The plane that it lies in."""
        return self.arcs[0].plane

    @property
    def closed(self) -> bool:
        """Always true: the last arc is joined to the first."""
        return True

    @property
    def count(self) -> int:
        """Pieces of the arcs, and one more for each line."""
        return len(self._piece)

    @property
    def length(self) -> float:
        """Length of the arcs and the lines."""
        return float(self._lengths.sum())

    @property
    def error_estimate(self) -> float:
        """Error of the length: at most that of the whole section curve."""
        return self.arcs[0].error_estimate

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate."""
        return sum(arc.approximation_error for arc in self.arcs)

    @cached_property
    def length_by_region(self) -> dict[str, float]:
        """Length of the arcs inside each body region."""
        return self._pieces.length_by_region

    @cached_property
    def bridges(self) -> Array:
        """Ends of the lines, shape (arcs, 2, 3)."""
        ends = [arc.positions_at(np.array([0.0, float(arc.count)])) for arc in self.arcs]
        return np.array([[end[1], ends[(i + 1) % len(ends)][0]] for i, end in enumerate(ends)])

    @cached_property
    def _pieces(self) -> SectionLoop:
        return joined(self.arcs)

    @cached_property
    def _piece(self) -> Ints:
        """Number of each row's piece among those of all arcs; of a line, -1 less its number."""
        rows, before = [], 0
        for number, arc in enumerate(self.arcs):
            rows += [np.arange(before, before + arc.count), np.array([-1 - number])]
            before += arc.count
        return np.concatenate(rows)

    @cached_property
    def _lengths(self) -> Array:
        result = np.empty(self.count)
        on_arc = self._piece >= 0
        result[on_arc] = self._pieces.piece_length
        result[~on_arc] = np.linalg.norm(self.bridges[:, 1] - self.bridges[:, 0], axis=1)
        return result

    def positions_at(self, place: Array) -> Array:
        """Return positions (n, 3) at places (n,)."""
        piece, fraction, on_arc = self._split(place)
        result: Array = np.empty((len(place), 3))
        result[on_arc] = self._pieces.positions_at(piece[on_arc] + fraction[on_arc])
        start, stop = self.bridges[-1 - piece[~on_arc]].transpose(1, 0, 2)
        result[~on_arc] = start + fraction[~on_arc, None] * (stop - start)
        return result

    def arc_length_at(self, place: Array) -> Array:
        """Return lengths (n,) from the start to places (n,)."""
        piece, fraction, on_arc = self._split(place)
        row = np.minimum(place.astype(np.int64), self.count - 1)
        before = np.concatenate([[0.0], np.cumsum(self._lengths)])[row]
        way = fraction * self._lengths[row]
        some = self._pieces.pieces.take(piece[on_arc])
        some = some.between(np.zeros(len(some)), fraction[on_arc])
        way[on_arc] = self._pieces.surface.lengths(some, MORE_NODES)
        return np.asarray(before + way)

    def velocities(self, row: Ints, fraction: Array) -> Array:
        """Return derivatives (n, k, 3) by the fraction, at fractions (n, k) of pieces (n,)."""
        piece = self._piece[row]
        on_arc = piece >= 0
        result: Array = np.empty((*fraction.shape, 3))
        result[on_arc] = self._pieces.velocities(piece[on_arc], fraction[on_arc])
        start, stop = self.bridges[-1 - piece[~on_arc]].transpose(1, 0, 2)
        result[~on_arc] = (stop - start)[:, None]
        return result

    def surface_points_at(self, place: Array) -> tuple[Ints, Array]:
        """Return patches (n,) and (u, v) on them (n, 2) at places (n,); -1 and NaN on the lines."""
        piece, fraction, on_arc = self._split(place)
        patch, parameters = np.full(len(place), -1), np.full((len(place), 2), np.nan)
        patch[on_arc], parameters[on_arc] = self._pieces.surface_points_at(
            piece[on_arc] + fraction[on_arc]
        )
        return patch, parameters

    def _split(self, place: Array) -> tuple[Ints, Array, Bools]:
        row = np.minimum(place.astype(np.int64), self.count - 1)
        piece = self._piece[row]
        return piece, place - row, piece >= 0
