"""The steps of graphs over grids of points, on which shortest ways are sought."""

from functools import lru_cache
from math import gcd

# The longest step, in lines of the grid: with all coprime pairs up to 3, steps lead in 16
# directions, and ways of such steps are a few percent too long. Fewer miss paths round a bump.
LONGEST = 3
# Sparse matrices hold no zeros, so that a step of no length, as on the collapsed side of a patch,
# must have this one.
SHORTEST = 1e-300


@lru_cache(maxsize=1)
def grid_steps() -> tuple[tuple[int, int], ...]:
    """Return every step (i, j) in grid lines, one of each pair of opposite ones."""
    return tuple(
        (i, j)
        for i in range(LONGEST + 1)
        for j in range(-LONGEST, LONGEST + 1)
        if gcd(i, j) == 1 and (i, j) > (0, 0)
    )
