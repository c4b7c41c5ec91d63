"""The memory that large atlases take is in proportion to their patches, and little for each."""

import tracemalloc
from collections.abc import Callable

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

import bodymeasure as bm
from bodymeasure.atlas import Atlas, summarize

SIDE = 120
# Bytes: a bicubic patch's control points take 384; what is treated in blocks takes the rest.
OF_A_PATCH, OF_A_BLOCK = 1500, 60e6


def wave(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.stack([x, y, 0.2 * np.sin(x + 2.0 * y)], axis=-1)


@pytest.fixture(scope="module")
def large() -> Atlas:
    atlas = grid_atlas(SIDE, SIDE, wave)
    assert atlas.control_points.nbytes
    return atlas


def peak(work: Callable[[], object]) -> int:
    """Return the most memory that arrays and objects take while something is done."""
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.slow
@pytest.mark.parametrize("work", [bm.check_atlas, summarize, bm.boundary_lengths])
def test_large_atlases_take_little_memory(large: Atlas, work: Callable[[Atlas], object]) -> None:
    assert peak(lambda: work(large)) < OF_A_PATCH * len(large) + OF_A_BLOCK
