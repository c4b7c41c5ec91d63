"""Lines inside of a piece that keep their lengths."""

from functools import cache

import numpy as np
import pytest
import scipy
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.pattern.flat.constraints import Constraints
from bodymeasure.pattern.flat.level_line import LevelLine, level_line


@cache
def piece() -> bm.Piece:
    return bm.make_pattern(interpolated(cylinder), four_geodesics()).pieces[0]


def line_at(height: float) -> LevelLine | None:
    """The line at a height of the flat piece."""
    return level_line(piece().flat.mesh, piece().flat.positions[:, 1] - height)


def test_a_line_across_a_piece_is_as_long_as_the_piece_lies_flat() -> None:
    # A panel of a cylinder lies flat without strain, so that its line has the length there.
    flat = piece().flat.positions
    line = line_at(float(flat[:, 1].mean()))
    assert line is not None
    assert np.abs(line.ways(flat)[:, 1]).max() < 1e-12
    assert line.length == pytest.approx(line.measured(flat), rel=1e-5)
    assert line.length == pytest.approx(line.lengths.sum())
    assert line.length > 0.5 * float(np.ptp(flat[:, 0]))


def test_a_line_that_does_not_cross_the_piece_is_none() -> None:
    assert line_at(float(piece().flat.positions[:, 1].max()) + 1.0) is None


def test_a_line_along_an_edge_is_none() -> None:
    mesh = piece().flat.mesh
    # Points of the border lie above it, and those next to them below.
    above = -np.ones(len(mesh.start))
    above[np.concatenate([chain.vertices for chain in mesh.chains])] = 1.0
    assert level_line(mesh, above) is None


def test_a_line_near_an_edge_is_none() -> None:
    # Two lengths that are kept side by side would pucker the cloth between them.
    flat = piece().flat.positions
    (points,) = piece().edge("ab").parts
    start, along = points[0], points[-1] - points[0]
    aside = np.array([-along[1], along[0]]) / np.linalg.norm(along)
    away = np.abs((flat - start) @ aside)
    assert level_line(piece().flat.mesh, away - 0.012, 0.025) is None
    assert level_line(piece().flat.mesh, away - 0.012, 0.005) is not None
    assert level_line(piece().flat.mesh, away - 0.05, 0.025) is not None


def test_the_derivatives_of_lines_agree_with_differences(rng: np.random.Generator) -> None:
    line = line_at(float(piece().flat.positions[:, 1].mean()))
    assert line is not None
    count = len(piece().flat.positions)
    constraints = Constraints(
        np.zeros((0, 2), np.int64),
        np.zeros(0),
        scipy.sparse.csr_array((0, 2 * count)),
        np.zeros(0),
        (line,),
    )
    flat = piece().flat.positions + 1e-3 * rng.normal(size=(count, 2))
    way, step = rng.normal(size=(count, 2)), 1e-6

    def slope(layout: Array) -> float:
        return float((constraints.jacobian(layout) @ way.ravel())[0])

    ahead, back = (flat + sign * step * way for sign in (1.0, -1.0))
    change = (constraints.values(ahead) - constraints.values(back))[0] / (2.0 * step)
    assert slope(flat) == pytest.approx(change, rel=1e-6)
    bend = float(way.ravel() @ (constraints.curvature(np.ones(1), flat) @ way.ravel()))
    assert bend == pytest.approx((slope(ahead) - slope(back)) / (2.0 * step), rel=1e-5)
