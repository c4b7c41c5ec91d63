"""Paths as trimesh's objects."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure.errors import MissingExtraError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.mesh.path import MeshPath
from bodymeasure.mesh.points import points_of

if TYPE_CHECKING:
    from trimesh.path import Path3D


def path_to_trimesh(path: AtlasPath | MeshPath | ArrayLike) -> "Path3D":
    """Return a path as a `trimesh.path.Path3D`, to be shown in a scene or exported.

    Parameters
    ----------
    path : AtlasPath, MeshPath or array_like of shape (k, 3)

    Returns
    -------
    trimesh.path.Path3D
        One line; ``metadata`` has the length, its error estimate and the unit.

    Raises
    ------
    InputError
        If it is no path.
    MissingExtraError
        If trimesh is not installed.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> line = bm.path_to_trimesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0)])
    >>> print(line.length)
    2.0
    """
    try:
        from trimesh.path import Path3D
        from trimesh.path.entities import Line
    except ImportError:
        raise MissingExtraError("a path for trimesh", "trimesh", "oracle") from None
    points, facts = points_of("given", path)
    line: Any = Line
    return Path3D(entities=[line(np.arange(len(points)))], vertices=points, metadata=facts)
