"""Points on the edges and corners of patches, and a hair off them."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from hypothesis import strategies as st

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.seams import EDGES, edge_table
from bodymeasure.atlas.topology.joins import over_sides

Triple = tuple[AtlasPoint, AtlasPoint, AtlasPoint]
# The powers of ten of the distances from an edge, in the parameter.
NEAREST, FARTHEST = -16.0, -6.0


def beside(edge: float, exponent: float) -> float:
    """The parameter that is a power of ten away from the edge at 0 or 1."""
    return float(abs(edge - 10.0**exponent))


def random_near_point(rng: np.random.Generator, atlas: Atlas) -> AtlasPoint:
    """A point whose parameters are each anywhere, or on an edge, or beside one."""

    def parameter() -> float:
        edge = float(rng.integers(2))
        choices = (rng.random(), edge, beside(edge, rng.uniform(NEAREST, FARTHEST)))
        return float(choices[rng.integers(3)])

    return AtlasPoint(int(rng.integers(len(atlas))), parameter(), parameter())


def random_near_triple(rng: np.random.Generator, atlas: Atlas) -> Triple:
    """Three points such as these; half the time, the second is beside the first, over a seam."""
    first, second, third = (random_near_point(rng, atlas) for _ in range(3))
    if rng.random() < 0.5:
        side = int(rng.integers(len(atlas))), int(rng.integers(4))
        along = (rng.random(), float(rng.integers(2)), beside(0.0, rng.uniform(NEAREST, FARTHEST)))
        exponents = rng.uniform(NEAREST, FARTHEST, 2).tolist()
        first, second = on_both_sides(atlas, *side, float(along[rng.integers(3)]), exponents)
    return first, second, third


def on_both_sides(
    atlas: Atlas, patch: int, side: int, along: float, exponents: Sequence[float]
) -> tuple[AtlasPoint, AtlasPoint]:
    """Two points beside one another, one on each side of a seam; on a boundary, both on one."""
    to_patch, to_side, flipped = (each[patch, side] for each in over_sides(edge_table(atlas.index)))
    if to_patch < 0:
        to_patch, to_side, flipped = patch, side, False
    return (
        _beside_side(patch, side, along, exponents[0]),
        _beside_side(int(to_patch), int(to_side), 1.0 - along if flipped else along, exponents[1]),
    )


def _beside_side(patch: int, side: int, along: float, exponent: float) -> AtlasPoint:
    off = beside(EDGES[side].fixed_value, exponent)
    u, v = (off, along) if EDGES[side].fixed_axis == 0 else (along, off)
    return AtlasPoint(patch, u, v)


def near_points(atlas: Atlas) -> st.SearchStrategy[AtlasPoint]:
    """Points whose parameters are each anywhere, or on an edge, or beside one."""
    parameter = _parameters()
    return st.builds(AtlasPoint, st.integers(0, len(atlas) - 1), parameter, parameter)


def near_triples(atlas: Atlas) -> st.SearchStrategy[Triple]:
    """Three such points, of which the first two may be beside one another, over a seam."""
    points, exponents = near_points(atlas), st.tuples(*[st.floats(NEAREST, FARTHEST)] * 2)
    sides = st.integers(0, len(atlas) - 1), st.integers(0, 3)
    pairs = st.builds(partial(on_both_sides, atlas), *sides, _parameters(), exponents)
    return st.one_of(
        st.tuples(points, points, points),
        st.builds(lambda pair, third: (*pair, third), pairs, points),
    )


def _parameters() -> st.SearchStrategy[float]:
    edge = st.sampled_from([0.0, 1.0])
    off = st.builds(beside, edge, st.floats(NEAREST, FARTHEST))
    return st.one_of(st.floats(0.0, 1.0), edge, off)
