"""Newton's method and lengths on one trial space, compiled, for bicubic patches."""

from functools import lru_cache
from typing import Any

import numpy as np

from bodymeasure.geodesic.graph.problems import OffsetProblems
from bodymeasure.geodesic.graph.rung import (
    GUESS_STEPS,
    LONGEST_STEP,
    MAX_OFFSET,
    Climbed,
    Rung,
    guess_space,
    inner_maps,
)
from bodymeasure.geodesic.lengths import jacobi
from bodymeasure.geodesic.lengths.compiled import LENGTH_SETTINGS, length_tables
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.solving.on_spaces import FAR_OUTSIDE
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.native import (
    DiagonalProblems,
    DiagonalSettings,
    DiagonalSpace,
    diagonal_paths,
    is_compiled,
)

# The control points of the patches that the kernel is written for.
SHAPE = (4, 4, 3)


def serves(nets: Any) -> bool:
    """Return whether there is a kernel for patches of these control points."""
    return is_compiled() and isinstance(nets, np.ndarray) and nets.shape[1:] == SHAPE


def is_served(space: TrialSpace) -> bool:
    """Return whether there is a kernel for a space: it is made for single, smooth pieces."""
    return space.size >= jacobi.FEW and len(space.quadrature.widths) == 1


def climb(problems: OffsetProblems, rest: Any, rung: Rung, offset: Any) -> Climbed:
    """Return what becomes of problems on a trial space; see `arrays.climb`."""
    settings = _settings(rung.steps, rung.small, rung.tolerance, problems.rounding)
    given = DiagonalProblems(problems.nets, problems.start, problems.end, problems.are_corners)
    before = _guessing() if offset is None else offset.T
    found = diagonal_paths(given, rest, _tables(rung.before, rung.space), settings, before)
    length = Length(
        found.raw, found.correction, found.error, found.residual, found.index, found.trusted
    )
    done = PathBatch(
        found.problem,
        rung.space.with_lines,
        found.values,
        length,
        found.good,
        np.zeros(len(found.good), bool),
        reach=found.reach,
        chord=found.chord,
    )
    return Climbed(done, found.left, found.offset.T)


@lru_cache(maxsize=64)
def _settings(steps: int, small: float, tolerance: float, rounding: float) -> DiagonalSettings:
    return DiagonalSettings(
        guess_steps=GUESS_STEPS,
        steps=steps,
        longest_step=LONGEST_STEP,
        small=small,
        most_offset=MAX_OFFSET,
        far_outside=FAR_OUTSIDE,
        tolerance=tolerance,
        rounding=rounding,
        **LENGTH_SETTINGS,
    )


@lru_cache(maxsize=1)
def _guessing() -> DiagonalSpace:
    space = guess_space()
    times = space.nodes[1:-1]
    return DiagonalSpace(times, np.zeros((len(times), 0)), inner_maps(space, times)[1:])


@lru_cache(maxsize=64)
def _tables(before: TrialSpace, space: TrialSpace) -> DiagonalSpace:
    times = space.nodes[1:-1]
    carry, slopes = inner_maps(before, times)[0], inner_maps(space, times)[1:]
    lengths = length_tables(space, inner_maps(space, space.quadrature.points))
    # These are functions that vanish at the ends, so that they need no straight lines.
    between = space.times_between, space.between_nodes[:, 1:-1]
    return DiagonalSpace(times, carry, slopes, lengths, between)
