"""The amount that is measured: in full, or quickly."""

from collections.abc import Mapping
from dataclasses import dataclass

from bodymeasure.bench.entrants.entrant import Pace


@dataclass(frozen=True)
class Size:
    """Numbers of problems and of repeats.

    Parameters
    ----------
    mild, wild, body : int
        Problems drawn for each set.
    limits : mapping of pace to int
        The most problems that a method of each pace is given; those of pace "batch" get all.
    rounds : int
        How often each method is timed; those of pace "very slow" only in every second round.
    largest_exponent : int
        Growth is measured from 10 patches to this power of ten.
    measurements : int
        Measurements of each kind drawn on a body. They are timed half as often.
    """

    mild: int
    wild: int
    body: int
    limits: Mapping[Pace, int]
    rounds: int
    largest_exponent: int
    measurements: int

    @property
    def body_rounds(self) -> int:
        """How often measurements of a body are timed."""
        return (self.rounds + 1) // 2


# This takes some twelve minutes, most of them for libigl and pygeodesic.
FULL = Size(
    mild=2000,
    wild=500,
    body=752,
    limits={"fast": 200, "slow": 20, "very slow": 20},
    rounds=6,
    largest_exponent=6,
    measurements=8,
)
# This takes some two minutes, most of them for charts and loops: enough to see that all works, but
# not for figures to quote.
QUICK = Size(
    mild=200,
    wild=40,
    body=120,
    limits={"fast": 20, "slow": 4, "very slow": 1},
    rounds=2,
    largest_exponent=4,
    measurements=2,
)
