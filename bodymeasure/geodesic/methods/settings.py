"""Checks of the settings that several methods share."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bodymeasure.errors import InputError


def check_positive(name: str, value: float) -> None:
    """Raise an InputError unless a setting is a positive, finite number."""
    if not _is_between(value, 0.0, np.inf) or value == 0.0:
        raise InputError(f"{name} is {value!r}; expected a positive number")


def check_between(name: str, value: float, least: float, most: float) -> None:
    """Raise an InputError unless a setting is a number from least to most."""
    if not _is_between(value, least, most):
        raise InputError(f"{name} is {value!r}; expected a number from {least:g} to {most:g}")


def _is_between(value: Any, least: float, most: float) -> bool:
    try:
        return np.ndim(value) == 0 and bool(np.isfinite(value) and least <= value <= most)
    except (TypeError, ValueError):
        return False


def whole_numbers(name: str, value: int | Sequence[int], least: int) -> tuple[int, ...]:
    """Return one whole number, or several to be tried in turn, as a tuple.

    Raises
    ------
    InputError
        If there are none, or one is not whole or less than `least`.
    """
    given: Any = value
    try:
        numbers = (given,) if np.ndim(given) == 0 else tuple(given)
    except (TypeError, ValueError):
        numbers = ()
    if not numbers or not all(
        isinstance(n, int | np.integer) and not isinstance(n, bool) and n >= least for n in numbers
    ):
        raise InputError(
            f"{name} is {value!r}; expected a whole number of at least {least}, or several to be "
            "tried in turn"
        )
    return tuple(int(n) for n in numbers)
