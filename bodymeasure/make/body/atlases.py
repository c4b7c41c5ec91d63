"""Atlases of the bodies of the space, which are linear in the coefficients."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.fit.model import atlas_of_vertices, body_model, control_points_of

COUNT = 120


@cache
def point_components() -> Array:
    """Return how each component moves the control points, shape (120, 3429, 3), in meters."""
    components = body_model().components
    right = components.transpose(1, 0, 2).reshape(components.shape[1], -1)
    points = control_points_of(right).reshape(-1, len(components), 3)
    return np.ascontiguousarray(points.transpose(1, 0, 2))


@cache
def _mean() -> Atlas:
    return atlas_of_vertices(body_model().mean)


def atlas_of(
    coefficients: Array, *, name: str = "", provenance: Mapping[str, str] | None = None
) -> Atlas:
    """Return the atlas of a body of the space, with the landmarks that all of them carry.

    Parameters
    ----------
    coefficients : ndarray, shape (120,)
    name : str
    provenance : mapping of str to str, optional
    """
    mean = _mean()
    points = mean.points + np.tensordot(coefficients, point_components(), 1)
    return replace(mean, points=points, name=name, provenance=provenance or {})
