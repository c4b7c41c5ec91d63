"""Points on the edges and corners of patches, and a hair off them."""

import numpy as np
from hypothesis import strategies as st

from bodymeasure.atlas import Atlas, AtlasPoint

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


def near_points(atlas: Atlas) -> st.SearchStrategy[AtlasPoint]:
    """Points whose parameters are each anywhere, or on an edge, or beside one."""
    edge = st.sampled_from([0.0, 1.0])
    off = st.builds(beside, edge, st.floats(NEAREST, FARTHEST))
    parameter = st.one_of(st.floats(0.0, 1.0), edge, off)
    return st.builds(AtlasPoint, st.integers(0, len(atlas) - 1), parameter, parameter)
