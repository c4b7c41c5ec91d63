"""The points of paths, in whatever form they come."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.mesh.path import MeshPath

# Points along a path over the smooth surface: on a body, their chain is as long to four digits.
PATH_POINTS = 400


def points_of(
    name: str, given: AtlasPath | MeshPath | ArrayLike, unit: Unit | None = None
) -> tuple[Array, dict[str, Any]]:
    """Return a path's points (k, 3), and what is known of its length.

    Parameters
    ----------
    name : str
        What errors call the path.
    given : AtlasPath, MeshPath or array_like of shape (k, 3)
    unit : Unit, optional
        Unit of the points; a path in another one is refused.

    Raises
    ------
    InputError
        If it is no path.
    """
    if isinstance(given, AtlasPath):
        if unit not in (None, given.atlas.unit):
            raise InputError(
                f"path {name} is in {given.atlas.unit}, but {unit} is expected; measure it on the "
                "same atlas"
            )
        facts = {
            "length": given.length,
            "error_estimate": given.error_estimate,
            "unit": given.atlas.unit.value,
        }
        return given.position(np.linspace(0.0, 1.0, PATH_POINTS)), facts
    if isinstance(given, MeshPath):
        said = "" if given.unit is None else given.unit.value
        facts = {"length": given.length, "error_estimate": given.error_estimate, "unit": said}
        return given.points, facts
    try:
        points = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        points = np.empty(0)
    if points.ndim != 2 or points.shape[1:] != (3,) or not np.isfinite(points).all():
        raise InputError(
            f"path {name} is no path; expected an AtlasPath, a MeshPath, or finite points (k, 3)"
        )
    return points, {}
