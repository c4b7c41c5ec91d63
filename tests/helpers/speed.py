"""Values of which the fast tests take some, and the slow tests the others."""

from collections.abc import Iterable
from typing import Any

import pytest


def quick(values: Iterable[Any], *, first: int = 1) -> list[Any]:
    """Return the parameters of a test, of which those after the first few are slow."""
    return [
        pytest.param(value, marks=() if number < first else pytest.mark.slow)
        for number, value in enumerate(values)
    ]
