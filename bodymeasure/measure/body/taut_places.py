"""The places of a closed curve on the taut tape around it."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.section import Curve, DrawnTape, Hull


@dataclass(frozen=True, eq=False)
class TautPlaces:
    """A taut tape around a closed curve, addressed by the places of the curve.

    A place on the tape stays where it is; one in a hollow goes perpendicularly to the straight part
    that spans it, or to that part's end.

    Parameters
    ----------
    curve : Curve
    hull : Hull
        Length of the curve.
    start, width : ndarray, shape (k,)
        Start and width of each span along the curve, counted from the start of the first.
    origin : float
        Length along the curve at which the first span starts.
    """

    curve: Curve
    hull: Hull
    start: Array
    width: Array
    origin: float

    @classmethod
    def on(cls, curve: Curve, hull: Hull) -> "TautPlaces":
        """Return the places of a curve and its hull."""
        ends = curve.arc_length_at(hull.spans.ravel()).reshape(-1, 2)
        origin = float(ends[0, 0]) if len(ends) else 0.0
        start = (ends[:, 0] - origin) % curve.length
        return cls(curve, hull, start, (ends[:, 1] - ends[:, 0]) % curve.length, origin)

    def run(self, first: float, last: float) -> float:
        """Return the length of the tape from one place forwards to another; twice the same, all."""
        begin, end = (self._along(place) for place in (first, last))
        return end - begin if end >= begin else self.hull.length - (begin - end)

    def drawn(self, places: Array) -> DrawnTape:
        """Return the tape at places in order; it is straight between them, as over hollows.

        Parameters
        ----------
        places : ndarray, shape (n,)
            Places in hollows, except the first and the last, are left out.
        """
        spans = np.array([self._span(float(place)) for place in places])
        inner = np.concatenate([[False], spans[1:-1] < 0, [False]])
        kept = [places[inner]]
        rank = np.flatnonzero(inner).astype(np.float64)
        # The ends of spans that the tape passes come before and after what is left out there.
        for change in np.flatnonzero(np.diff(spans)):
            crossed = [
                self.hull.spans[span, end]
                for span, end in ((spans[change], 1), (spans[change + 1], 0))
                if span >= 0
            ]
            kept.append(np.array(crossed))
            rank = np.append(rank, change + (1.0 + np.arange(len(crossed))) / (len(crossed) + 1.0))
        on_tape = np.concatenate(kept)[np.argsort(rank)]
        patch, parameters = self.curve.surface_points_at(on_tape)
        begin, end = (self._end(places[row], int(spans[row])) for row in (0, -1))
        return DrawnTape(
            np.concatenate([begin.positions, self.curve.positions_at(on_tape), end.positions]),
            np.concatenate([begin.patch, patch, end.patch]),
            np.concatenate([begin.parameters, parameters, end.parameters]),
        )

    def _end(self, place: float, span: int) -> DrawnTape:
        at = np.array([place])
        if span < 0:
            return DrawnTape(self.curve.positions_at(at), *self.curve.surface_points_at(at))
        one, other = self.hull.bridges[span]
        foot = one + self._across(place, span) * (other - one)
        return DrawnTape(foot[None], np.array([-1]), np.full((1, 2), np.nan))

    def _span(self, place: float) -> int:
        """Return the span inside which a place lies, -1 if none."""
        first, last = self.hull.spans.T
        after, before = place > first, place < last
        inside = np.where(first < last, after & before, after | before)
        return int(np.flatnonzero(inside)[0]) if inside.any() else -1

    def _across(self, place: float, span: int) -> float:
        """Return the fraction of a straight part that is opposite to a place in its hollow."""
        one, other = self.hull.bridges[span]
        chord = other - one
        point = self.curve.positions_at(np.array([place]))[0]
        return float(np.clip((point - one) @ chord / (chord @ chord), 0.0, 1.0))

    def _along(self, place: float) -> float:
        """Return the length along the tape from the first span's start to a place."""
        chords = np.linalg.norm(self.hull.bridges[:, 1] - self.hull.bridges[:, 0], axis=1)
        saved, span = self.width - chords, self._span(place)
        if span >= 0:
            passed = self.start < self.start[span]
            before = float(self.start[span] - saved[passed].sum())
            return before + self._across(place, span) * float(chords[span])
        length = float(self.curve.arc_length_at(np.array([place]))[0] - self.origin)
        length %= self.curve.length
        # A span that ends there has been passed, whatever rounding makes of its end.
        passed = self.start + 0.5 * self.width < length
        return length - float(saved[passed].sum())
