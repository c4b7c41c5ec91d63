import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from bodymeasure.bezier import bernstein, bezier_pieces
from bodymeasure.errors import InputError


@st.composite
def splines(draw: st.DrawFn) -> tuple[int, list[float], np.random.Generator]:
    """Draw a degree and a knot vector, clamped or not, with knots of any multiplicity."""
    degree = draw(st.integers(1, 5))
    steps = draw(
        st.lists(st.sampled_from([0.0, 0.0, 0.5, 1.0, 3.0]), min_size=2 * degree + 1, max_size=18)
    )
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    count = len(knots) - degree - 1
    if not knots[degree] < knots[count]:
        knots[count:] += 1.0
    return degree, knots.tolist(), np.random.default_rng(draw(st.integers(0, 2**32 - 1)))


@given(splines())
def test_pieces_are_the_spline(spline: tuple[int, list[float], np.random.Generator]) -> None:
    degree, knots, rng = spline
    points = rng.normal(size=(len(knots) - degree - 1, 3))
    pieces = bezier_pieces(points, degree, knots)
    t = np.linspace(0.05, 0.95, 7)
    for net, (start, end) in zip(*pieces, strict=True):
        assert start < end
        found = bernstein(degree, t)[:, 0] @ net
        # At the ends of its domain scipy evaluates the piece beyond; inside, both are one
        # polynomial.
        expected = BSpline(knots, points, degree)(start + t * (end - start))
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-14)
    assert pieces.breaks[0, 0] == knots[degree]
    assert pieces.breaks[-1, 1] == knots[-degree - 1]
    np.testing.assert_array_equal(pieces.breaks[1:, 0], pieces.breaks[:-1, 1])


def test_neighbors_share_their_joint_unless_the_spline_jumps(rng: np.random.Generator) -> None:
    knots = [0, 0, 0, 0, 0.3, 0.3, 0.7, 0.7, 0.7, 0.7, 1, 1, 1, 1]
    points = rng.normal(size=(10, 3))
    pieces = bezier_pieces(points, 3, knots).control_points
    assert len(pieces) == 3
    np.testing.assert_array_equal(pieces[0, -1], pieces[1, 0])
    np.testing.assert_array_equal(pieces[1, -1], points[5])
    np.testing.assert_array_equal(pieces[2, 0], points[6])


def test_a_clamped_spline_without_inner_knots_is_bezier_to_the_last_bit(
    rng: np.random.Generator,
) -> None:
    points = rng.normal(size=(4, 5, 3))
    (piece,) = bezier_pieces(points, 3, [2, 2, 2, 2, 5, 5, 5, 5]).control_points
    assert piece.tobytes() == points.tobytes()


def test_a_periodic_spline_closes(rng: np.random.Generator) -> None:
    ring = rng.normal(size=(6, 3))
    points = np.concatenate([ring, ring[:3]])
    pieces = bezier_pieces(points, 3, np.arange(13.0)).control_points
    assert len(pieces) == 6
    np.testing.assert_allclose(pieces[-1, -1], pieces[0, 0], rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("count", "degree", "knots", "message"),
    [
        (4, 3, [0, 0, 0, 0, 1, 1, 1], "7 knots for 4 control points of degree 3; expected 8"),
        (3, 3, [0, 0, 0, 1, 1, 1, 1], "degree 3 has 3 control points"),
        (4, 0, [0, 0, 0, 0, 1], "degree 0 has 4"),
        (4, 3, [0, 0, 0, 1, 0.5, 1, 1, 1], "knots decrease from 1 to 0.5"),
        (4, 3, [0, 0, 0, 1, 1, 1, 1, 1], "from the 4th to the 5th are all 1"),
        (4, 3, [0, 0, 0, 0, 1, 1, 1, np.nan], "not finite"),
        (4, 3, [-1e308, 0, 0, 0, 1, 1, 1, 1e308], "not finite"),
    ],
)
def test_bad_knots_are_refused(count: int, degree: int, knots: list[float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        bezier_pieces(np.zeros((count, 3)), degree, knots)
