"""A survey of straight (u, v) diagonals with made-up differences, for tests of its drawing."""

from types import SimpleNamespace
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Atlas


def straight_survey(
    atlas: Atlas,
    *,
    difference: float | Array = 1e-6,
    no_length: Bools | None = None,
    check: bool = True,
    bulge: float = 0.0,
) -> Any:
    """A survey with this relative difference from the mesh; `bulge` bends the paths in (u, v)."""
    shape = (len(atlas), 2)
    missing = np.zeros(shape, dtype=bool) if no_length is None else no_length
    start = np.broadcast_to([[0.0, 0.0], [1.0, 0.0]], (*shape, 2))
    end = np.broadcast_to([[1.0, 1.0], [0.0, 1.0]], (*shape, 2))
    length = np.where(missing, np.nan, 0.1)
    relative = np.where(missing, np.nan, np.broadcast_to(difference, shape))

    def path(t: Array) -> Array:
        parameters = start[..., None, :] + t[:, None] * (end - start)[..., None, :]
        bend = bulge * np.sin(np.pi * t)[:, None] * np.array([1.0, -1.0])
        return np.asarray(parameters + bend)

    status = np.where(missing, "left its patch", "converged").astype(object)
    return SimpleNamespace(
        atlas=atlas,
        diagonals=SimpleNamespace(start=start, end=end, length=length, status=status, path=path),
        cross_check=SimpleNamespace(relative_difference=relative) if check else None,
    )
