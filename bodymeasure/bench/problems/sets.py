"""The three sets of problems on which methods are compared, with their true lengths."""

from dataclasses import dataclass
from typing import Generic, Protocol, Self, TypeVar

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bench.problems.patches import (
    Problems,
    both_diagonals,
    first_diagonals,
    mild_patches,
    wild_patches,
)
from bodymeasure.bench.problems.reference import DEGREES, FINEST, GUESS_TIMES, geodesics
from bodymeasure.samples import load_sample

SEED = 2007
BODY = "female_average"
DIAGONALS = "diagonals"
# Heights of mild patches on the unit square, each for half of the patches.
MILD_HEIGHTS = (0.15, 0.3)
# The paper's heights over a square of side 1.
WILD_SIDE = 1.0
# Heights of the bows from which other geodesics are sought, which may be shorter.
BOWS = (-0.25, 0.25)


class Takes(Protocol):
    """Problems, some of which can be taken."""

    def take(self, rows: Ints | slice) -> Self:
        """Return some of the problems."""


Batch = TypeVar("Batch", bound=Takes)


@dataclass(frozen=True)
class ProblemSet(Generic[Batch]):
    """Problems of one kind whose true length is known, in random order.

    Parameters
    ----------
    name, title : str
        A name in one word, and a longer one.
    problems : Problems or BodyProblems
    truth : ndarray, shape (p,)
        Lengths by an independent method, or confirmed by one.
    drawn : int
        Number of problems that were drawn.
    leaving : int
        Number of those left out because their geodesic leaves the patch.
    unresolved : int
        Number of those left out because two resolutions of the independent method disagree, or
        because it does not confirm the length.
    noun : str
        What a problem is, in the plural.
    stated : ndarray, shape (p,), optional
        The relative errors that bodymeasure states, where the truth is its own length.
    confirmed_to : float, optional
        The median relative difference of such lengths from those of an independent method.
    """

    name: str
    title: str
    problems: Batch
    truth: Array
    drawn: int
    leaving: int
    unresolved: int
    noun: str = DIAGONALS
    stated: Array | None = None
    confirmed_to: float | None = None

    def __len__(self) -> int:
        return len(self.truth)


def mild_set(count: int) -> ProblemSet[Problems]:
    """Return random patches that are flat rather than curved."""
    rng = np.random.default_rng(SEED)
    parts = [
        mild_patches(rng, part, height)
        for part, height in zip((count // 2, count - count // 2), MILD_HEIGHTS, strict=True)
    ]
    problems = first_diagonals(np.concatenate(parts))
    return _known("mild", "mild random patches", problems, _straight_only(problems), rng)


def wild_set(count: int) -> ProblemSet[Problems]:
    """Return random patches as curved as the paper's, with the shortest of several geodesics."""
    rng = np.random.default_rng(SEED)
    problems = first_diagonals(wild_patches(rng, count, WILD_SIDE))
    return _known("wild", "wild random patches", problems, _shortest(problems), rng)


def body_set(count: int) -> ProblemSet[Problems]:
    """Return the diagonals of a body's patches, all or a random choice."""
    rng = np.random.default_rng(SEED)
    body = both_diagonals(load_sample(BODY))
    problems = body.take(rng.permutation(len(body.nets))[:count])
    return _known("body", f"patches of a body ({BODY})", problems, _straight_only(problems), rng)


def _straight_only(problems: Problems) -> tuple[Array, Bools]:
    known = geodesics(problems, pairs=FINEST)
    return known.length, known.leaves


def _shortest(problems: Problems) -> tuple[Array, Bools]:
    """Return lengths of the shortest geodesics found from straight and from bent starts."""
    length, leaves = _straight_only(problems)
    straight = (
        problems.start[:, None] + (problems.end - problems.start)[:, None] * (GUESS_TIMES[:, None])
    )
    bow = (4.0 * GUESS_TIMES * (1.0 - GUESS_TIMES))[:, None] * np.array([1.0, -1.0])
    for height in BOWS:
        # Only the first degrees are used, since a path that they do not resolve is no loss here.
        other = geodesics(problems, guess=straight + height * bow, pairs=DEGREES[:1]).length
        length = np.where(np.isnan(length), np.nan, np.fmin(length, other))
    return length, leaves


def _known(
    name: str,
    title: str,
    problems: Problems,
    reference: tuple[Array, Bools],
    rng: np.random.Generator,
) -> ProblemSet[Problems]:
    length, leaves = reference
    # Slow methods take the first few problems, which must not be special ones.
    rows = rng.permutation(np.flatnonzero(np.isfinite(length)))
    unresolved = len(length) - len(rows) - int(leaves.sum())
    return ProblemSet(
        name,
        title,
        problems.take(rows),
        length[rows],
        len(length),
        int(leaves.sum()),
        unresolved,
    )
