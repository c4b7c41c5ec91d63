"""From the vertices of the quad mesh to the atlas on the samples' layout: a fixed linear map."""

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
from scipy.sparse import csc_matrix, csr_matrix, triu
from scipy.sparse.linalg import splu

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.fit.model.space import DATA, body_model
from bodymeasure.samples import load_sample

# Patch names, regions, axes and unit are those of all samples of this layout.
LAYOUT = "female_average"
# The arrays of a sparse matrix, and the types that SciPy takes them in.
PARTS = {"data": np.float64, "indices": np.int32, "indptr": np.int32}


def atlas_of_vertices(
    vertices: Array, *, name: str = "", provenance: Mapping[str, str] | None = None
) -> Atlas:
    """Return the atlas of a body in any pose, with the carried landmarks.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        Control vertices of the quad mesh, in meters, z up, front = -y.
    name : str
    provenance : mapping of str to str, optional

    Returns
    -------
    Atlas
    """
    layout = load_sample(LAYOUT)
    return Atlas(
        points=control_points_of(vertices),
        index=_layout()[0],
        unit=layout.unit,
        patch_names=layout.patch_names,
        regions=layout.regions,
        landmarks=carried_landmarks(),
        axes=layout.axes,
        name=name,
        provenance=provenance or {},
    )


def control_points_of(vertices: Array) -> Array:
    """Return the control points, (3429, 3), of the atlas of a body with these vertices."""
    factors, right = _map()
    return np.asarray(factors.solve(np.ascontiguousarray(right @ vertices)))


def carried_landmarks() -> dict[str, AtlasPoint]:
    """Return the places of the landmarks that every body of the layout has."""
    return dict(_layout()[1])


@cache
def _map() -> tuple[Any, csr_matrix]:
    with np.load(DATA / "atlas_map.npz") as data:
        size, vertices = len(data["normal_indptr"]) - 1, len(body_model().mean)
        normal, right = (
            tuple(data[f"{name}_{part}"].astype(kind) for part, kind in PARTS.items())
            for name in ("normal", "right")
        )
    upper = csc_matrix(normal, shape=(size, size))
    whole = (upper + triu(upper, 1).T).tocsc()
    return splu(whole), csr_matrix(right, shape=(size, vertices))


@cache
def _layout() -> tuple[Ints, dict[str, AtlasPoint]]:
    with np.load(DATA / "atlas_map.npz") as data:
        names, patches = data["landmark_names"].tolist(), data["landmark_patch"].tolist()
        places = zip(names, patches, data["landmark_uv"].tolist(), strict=True)
        landmarks = {name: AtlasPoint(patch, u, v) for name, patch, (u, v) in places}
        return data["index"].astype(np.int64), landmarks
