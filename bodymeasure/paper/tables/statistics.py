"""Figures of sets of lengths: relative differences, and their means, medians and quantiles."""

import re

import numpy as np

from bodymeasure._typing import Array


def signed_difference(lengths: Array, reference: Array) -> Array:
    """Return the relative differences with their signs: equation (15) for each sample by itself.

    The sum in (15) has one term then. If it were taken over all samples, signs would be lost, and
    "mean accuracy loss" would not be a mean.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray((lengths - reference) / reference)


def known(values: Array) -> Array:
    """Return the values that are finite."""
    return values[np.isfinite(values)]


def mean(values: Array) -> float | None:
    """Return the mean; None without values."""
    return float(values.mean()) if len(values) else None


def median(values: Array) -> float | None:
    """Return the median; None without values."""
    return float(np.median(values)) if len(values) else None


def signed_rms(values: Array) -> float | None:
    """Return the root mean square with the sign of the mean; None without values."""
    if len(values) == 0:
        return None
    return float(np.sign(values.mean()) * np.sqrt(np.mean(values**2)))


def key(name: str) -> str:
    """Return a name for people as a part of names for programs."""
    return re.sub(r"\W+", "_", name).strip("_")
