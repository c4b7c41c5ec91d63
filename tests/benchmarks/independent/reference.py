"""The independent reference of the package, and the problems on which the scripts use it.

The reference itself is `bodymeasure.bench.problems.reference`, which `bodymeasure bench` uses too.
"""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bench.problems.patches import (
    Problems,
    both_diagonals,
    first_diagonals,
    mild_patches,
    wild_patches,
)
from bodymeasure.bench.problems.reference import (
    DEGREES,
    FINEST,
    GAUSS,
    GUESS_TIMES,
    WEIGHTS,
    Reference,
    geodesics,
)
from bodymeasure.samples import load_sample

__all__ = [
    "DEGREES",
    "FINEST",
    "GAUSS",
    "GUESS_TIMES",
    "WEIGHTS",
    "Problems",
    "Reference",
    "body_diagonals",
    "first_diagonals",
    "geodesics",
    "mild_patches",
    "symmetric",
    "wild_patches",
]


def body_diagonals(name: str) -> Problems:
    """Both diagonals of every patch of a sample, the order of ``bm.diagonals(...)`` flattened."""
    return both_diagonals(load_sample(name))


def symmetric(nets: Array) -> Array:
    """Patches whose heights are mirrored in the diagonal."""
    mirrored = nets.copy()
    lower = np.tril(nets[..., 2])
    mirrored[..., 2] = lower + np.swapaxes(np.tril(nets[..., 2], -1), 1, 2)
    return mirrored
