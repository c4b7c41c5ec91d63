"""Round numbers for the axes of drawings."""

import math


def round_step(least: float) -> float:
    """Return the smallest of 1, 2 and 5 times the powers of ten that is not less than a number."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= least)


def ticks(low: float, high: float, *, about: int = 4) -> list[float]:
    """Return round numbers between two, about so many."""
    step = round_step((high - low) / about)
    # Rounding must not lose an end that is such a number itself.
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]
