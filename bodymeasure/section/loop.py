"""One curve of a section."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Unit
from bodymeasure.section.pieces import CutSurface, Pieces
from bodymeasure.section.plane import Plane

# Fractions of a piece at which a loop is sampled, each piece's start included.
STEPS = 8


@dataclass(frozen=True, eq=False)
class SectionLoop:
    """A curve in which a plane cuts an atlas.

    Parameters
    ----------
    surface : CutSurface
        The patches that are cut, and the plane that cuts them.
    pieces : Pieces
        In the order in which they follow one another.
    piece_length : ndarray, shape (pieces,)
    error_estimate : float
        Estimated error of `length`, in `unit`.
    closed : bool
        Whether the curve returns to its start; else it ends on open boundaries of the atlas.
    unit : Unit
    regions : tuple of str
        Body region of each patch of the atlas.
    """

    surface: CutSurface = field(repr=False)
    pieces: Pieces = field(repr=False)
    piece_length: Array = field(repr=False)
    error_estimate: float
    closed: bool
    unit: Unit
    regions: tuple[str, ...] = field(repr=False)

    @property
    def length(self) -> float:
        """Length of the curve, in `unit`."""
        return float(self.piece_length.sum())

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate.

        It is 0 on an atlas that approximates nothing; see `bodymeasure.approximation_error`.
        """
        if self.surface.stretch is None:
            return 0.0
        return float(self.surface.stretch[self.pieces.patch] @ self.piece_length)

    @property
    def plane(self) -> Plane:
        """The plane that cuts."""
        return self.surface.plane

    @property
    def count(self) -> int:
        """How many pieces the curve has."""
        return len(self.pieces)

    @cached_property
    def _samples(self) -> tuple[Ints, Array, Array]:
        fraction = np.broadcast_to(np.arange(STEPS + 1) / STEPS, (len(self.pieces), STEPS + 1))
        parameters, positions, _ = self.surface.points(self.pieces, fraction)
        count = STEPS * len(self.pieces)
        patch = np.repeat(self.pieces.patch, STEPS)
        parameters, last = parameters[:, :-1].reshape(count, 2), parameters[-1, -1:]
        positions, end = positions[:, :-1].reshape(count, 3), positions[-1, -1:]
        if self.closed:
            return patch, parameters, positions
        return (
            np.append(patch, patch[-1]),
            np.concatenate([parameters, last]),
            np.concatenate([positions, end]),
        )

    @property
    def patch(self) -> Ints:
        """Patch of each sample point, shape (n,)."""
        return self._samples[0]

    @property
    def parameters(self) -> Array:
        """(u, v) of each sample point on its patch, shape (n, 2)."""
        return self._samples[1]

    @property
    def positions(self) -> Array:
        """Sample points in order along the curve, shape (n, 3); a closed one's start once."""
        return self._samples[2]

    def positions_at(self, place: Array) -> Array:
        """Return positions (n, 3) at places (n,): numbers of pieces plus the fractions run."""
        row, fraction = self._split(place)
        return self.surface.points(self.pieces.take(row), fraction[:, None])[1][:, 0]

    def arc_length_at(self, place: Array) -> Array:
        """Return lengths (n,) from the start to places (n,), as in `positions_at`."""
        row, fraction = self._split(place)
        pieces = self.pieces.take(row).between(np.zeros(len(row)), fraction)
        before = np.concatenate([[0.0], np.cumsum(self.piece_length)])
        return np.asarray(before[row] + self.surface.lengths(pieces))

    def motion(self, row: Ints, fraction: Array) -> tuple[Array, Array]:
        """Return positions and their derivatives by the fraction, both (n, k, 3).

        They are those at fractions (n, k) of pieces (n,).
        """
        return self.surface.points(self.pieces.take(row), fraction)[1:]

    def surface_points_at(self, place: Array) -> tuple[Ints, Array]:
        """Return patches (n,) and (u, v) on them (n, 2) at places (n,)."""
        row, fraction = self._split(place)
        pieces = self.pieces.take(row)
        return pieces.patch, self.surface.parameters(pieces, fraction[:, None])[:, 0]

    def _split(self, place: Array) -> tuple[Ints, Array]:
        row = np.minimum(place.astype(np.int64), len(self.pieces) - 1)
        return row, place - row

    @cached_property
    def length_by_region(self) -> dict[str, float]:
        """Length inside each body region that the curve crosses, in `unit`."""
        result: dict[str, float] = {}
        for patch, length in zip(self.pieces.patch.tolist(), self.piece_length, strict=True):
            region = self.regions[patch]
            result[region] = result.get(region, 0.0) + float(length)
        return result
