"""The bodies of a survey that are nearest to a size."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError


@dataclass(frozen=True)
class Near:
    """A body near a size.

    Parameters
    ----------
    body : int
        Its place in the survey.
    distance : float
        Root mean square of its differences from the size, each in standard deviations.
    differences : tuple of float
        In the units of the measurements, and their order.
    """

    body: int
    distance: float
    differences: tuple[float, ...]


def nearest_bodies(
    values: Mapping[str, Array], size: Mapping[str, float], count: int = 5
) -> tuple[Near, ...]:
    """Return the bodies that are nearest to a size.

    Parameters
    ----------
    values : mapping of str to ndarray, shape (bodies,)
        Of the size's measurements at least; NaN where there is none.
    size : mapping of str to float
    count : int
        How many, at most; bodies that lack a value are none of them.

    Raises
    ------
    InputError
        If the size has no measurement.
    """
    if not size:
        raise InputError("the size has no measurement; give some, such as waist_girth=72")
    table = np.column_stack([values[key] for key in size])
    whole = np.flatnonzero(np.isfinite(table).all(axis=1))
    if not len(whole):
        return ()
    table = table[whole]
    spread = table.std(axis=0, ddof=1) if len(whole) > 1 else np.ones(table.shape[1])
    apart = table - np.array(list(size.values()))
    distance = np.sqrt(np.mean((apart / np.where(spread > 0.0, spread, 1.0)) ** 2, axis=1))
    order = np.argsort(distance, kind="stable")[:count]
    return tuple(
        Near(int(whole[place]), float(distance[place]), tuple(map(float, apart[place])))
        for place in order
    )
