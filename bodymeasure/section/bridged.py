"""A closed curve of arcs of a section, joined by straight lines."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.part import joined
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
        row, fraction = self._split(place)
        return self.motion(row, fraction[:, None])[0][:, 0]

    def arc_length_at(self, place: Array) -> Array:
        """Return lengths (n,) from the start to places (n,)."""
        row, fraction = self._split(place)
        piece, on_arc = self._piece[row], self._piece[row] >= 0
        before = np.concatenate([[0.0], np.cumsum(self._lengths)])[row]
        way = fraction * self._lengths[row]
        some = self._pieces.pieces.take(piece[on_arc])
        some = some.between(np.zeros(len(some)), fraction[on_arc])
        way[on_arc] = self._pieces.surface.lengths(some)
        return np.asarray(before + way)

    def motion(self, row: Ints, fraction: Array) -> tuple[Array, Array]:
        """Return positions and their derivatives by the fraction, both (n, k, 3).

        They are those at fractions (n, k) of pieces (n,).
        """
        piece = self._piece[row]
        on_arc = piece >= 0
        position, velocity = np.empty((2, *fraction.shape, 3))
        position[on_arc], velocity[on_arc] = self._pieces.motion(piece[on_arc], fraction[on_arc])
        start, stop = self.bridges[-1 - piece[~on_arc], :, None].transpose(1, 0, 2, 3)
        position[~on_arc] = start + fraction[~on_arc, :, None] * (stop - start)
        velocity[~on_arc] = stop - start
        return position, velocity

    def surface_points_at(self, place: Array) -> tuple[Ints, Array]:
        """Return patches (n,) and (u, v) on them (n, 2) at places (n,); -1 and NaN on the lines."""
        row, fraction = self._split(place)
        piece, on_arc = self._piece[row], self._piece[row] >= 0
        patch, parameters = np.full(len(place), -1), np.full((len(place), 2), np.nan)
        patch[on_arc], parameters[on_arc] = self._pieces.surface_points_at(
            piece[on_arc] + fraction[on_arc]
        )
        return patch, parameters

    def _split(self, place: Array) -> tuple[Ints, Array]:
        row = np.minimum(place.astype(np.int64), self.count - 1)
        return row, place - row
