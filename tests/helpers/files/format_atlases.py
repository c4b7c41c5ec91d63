"""Atlases to write and read, and functions that do so without a file."""

import numpy as np
from helpers.surfaces.grids import grid_atlas
from hypothesis import strategies as st

from bodymeasure import Atlas, Unit
from bodymeasure._typing import Array
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.registry import FORMATS, decode

UNIT = Unit.CM
# Meshes are read without refining them.
ONE_PATCH_A_QUAD = ReadOptions(unit=UNIT, deviation=np.inf)
# Formats of loose patches as text.
TEXT = ("bpt", "bez", "obj", "geomdl")


def read(content: bytes, form: str, options: ReadOptions | None = None) -> Atlas:
    """The atlas in a file's content, in `UNIT` where the format has none."""
    unit = None if "unit" in FORMATS[form].keeps else UNIT
    return decode(content, "file", FORMATS[form], options or ReadOptions(unit=unit))


def write(atlas: Atlas, form: str) -> bytes:
    writer = FORMATS[form].write
    assert writer is not None
    return writer(atlas)


@st.composite
def atlases(draw: st.DrawFn, *, rational: bool = False) -> Atlas:
    """Patches on a grid, joined by index, of any degree, with coordinates of any size."""
    rows, columns = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    degree = draw(st.integers(3, 6))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    size = 10.0 ** draw(st.integers(-30, 30))
    far = draw(st.sampled_from([0.0, 1.0, 1e6]))
    shape = (degree * rows + 1, degree * columns + 1)
    number = np.arange(shape[0] * shape[1]).reshape(shape)
    index = np.array(
        [
            number[degree * i : degree * (i + 1) + 1, degree * j : degree * (j + 1) + 1]
            for i in range(rows)
            for j in range(columns)
        ]
    )
    points = size * (far + rng.uniform(-1.0, 1.0, (number.size, 3)))
    weights = rng.uniform(0.2, 5.0, number.size)[index] if rational else None
    return Atlas(points, index, UNIT, weights=weights)


def body_like(rows: int, columns: int) -> Atlas:
    """Patches of a wavy surface."""

    def place(x: Array, y: Array) -> Array:
        return np.stack([x, y, 0.2 * np.sin(x + 2.0 * y)], axis=-1)

    return grid_atlas(rows, columns, place)
