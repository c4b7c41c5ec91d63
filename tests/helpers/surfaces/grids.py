"""Atlases of bicubic patches on a rectangular grid, joined by index."""

from collections.abc import Callable

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, Unit


def grid_index(rows: int, columns: int) -> Ints:
    """The index of rows x columns patches on a lattice of control points; u runs along the rows."""
    lattice = np.arange((3 * rows + 1) * (3 * columns + 1)).reshape(3 * rows + 1, -1)
    return np.array(
        [lattice[3 * i : 3 * i + 4, 3 * j : 3 * j + 4] for i in range(rows) for j in range(columns)]
    )


def grid_atlas(
    rows: int,
    columns: int,
    place: Callable[[Array, Array], Array] | None = None,
) -> Atlas:
    """Patches of side 1 in the xy plane, or with their control points moved by `place(x, y)`."""
    x, y = np.meshgrid(np.arange(3 * rows + 1) / 3, np.arange(3 * columns + 1) / 3, indexing="ij")
    points = np.stack([x, y, 0.0 * x], axis=-1) if place is None else place(x, y)
    return Atlas(points.reshape(-1, 3), grid_index(rows, columns), Unit.CM)
