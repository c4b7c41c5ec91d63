"""Landmarks that a user has picked on a scan."""

from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import numbers, shown
from bodymeasure.errors import FitError, InputError
from bodymeasure.fit.model import carried_landmarks
from bodymeasure.fit.model.space import DATA
from bodymeasure.fit.solving.cloud import RIM, Cloud
from bodymeasure.wording import hint

# A pick farther from the scan than this, in meters, is not on it.
OFF = 0.03


class Picks(NamedTuple):
    """What a user has picked.

    Parameters
    ----------
    positions : mapping of str to ndarray of shape (3,)
        In meters, in the scan's frame.
    pulls : mapping of int to ndarray of shape (3,)
        Where the limit positions of some vertices should lie.
    warnings : tuple of str
    """

    positions: Mapping[str, Array]
    pulls: Mapping[int, Array]
    warnings: tuple[str, ...]


def picks_of(given: Mapping[str, ArrayLike] | None, meters: float, cloud: Cloud) -> Picks:
    """Return the user's picks, checked.

    Parameters
    ----------
    given : mapping of str to array_like of shape (3,), optional
        In the file's coordinates and unit.
    meters : float
        One unit of the file.
    cloud : Cloud

    Raises
    ------
    InputError
        If a name is none of the layout's landmarks, or a position is no position on the scan.
    """
    if given is not None and not isinstance(given, Mapping):
        raise InputError(f"landmarks is {shown(given)}; expected a mapping of names to positions")
    positions, pulls, warnings = {}, {}, []
    names = tuple(carried_landmarks())
    for name, value in (given or {}).items():
        if name not in names:
            raise InputError(f"no landmark is named {name!r}; {hint(name, names)}")
        position = numbers(value, f"the landmark {name!r}", "a position of three numbers") * meters
        if position.shape != (3,) or not np.isfinite(position).all():
            raise InputError(f"the landmark {name!r} is {shown(value)}; expected three numbers")
        distance, nearest = cloud.tree.query(position)
        if distance > OFF:
            raise FitError(
                f"the landmark {name!r} lies {distance * 1e3:.0f} mm from the scan; expected at "
                f"most {OFF * 1e3:.0f} mm; give it in the file's coordinates and unit"
            )
        positions[name] = position
        if cloud.at_rim[nearest]:
            warnings.append(
                f"The landmark {name!r} lies within {RIM * 1e3:g} mm of the rim of a hole, and did "
                "not pull the fit."
            )
        else:
            pulls[landmark_vertices()[name]] = position
    return Picks(positions, pulls, tuple(warnings))


@cache
def landmark_vertices() -> dict[str, int]:
    """The vertex of the mesh that each landmark stands for."""
    with np.load(DATA / "atlas_map.npz") as data:
        return dict(
            zip(data["landmark_names"].tolist(), data["landmark_vertex"].tolist(), strict=True)
        )
