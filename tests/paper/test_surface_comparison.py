import math
from dataclasses import replace

import numpy as np
import pytest

from bodymeasure.atlas import Unit
from bodymeasure.paper.surface.surface_comparison import Comparison, distribution, explain

FOUR = Comparison(
    unit=Unit.CM,
    patch=("a", "a", "b", "b"),
    place=("diagonal 1", "diagonal 2", "diagonal 1", "diagonal 2"),
    calculated=np.array([10.1, 4.9, 8.0, np.nan]),
    physical=np.array([10.0, 5.0, 8.0, 6.0]),
    uncertainty=np.array([1e-3, 1e-3, 1e-3, 1e-3]),
    laid=np.array([10.08, 5.0005, 8.0, np.nan]),
    laid_uncertainty=np.full(4, 1e-3),
    distance=np.array([0.05, 0.06, 0.0, 0.02]),
    offset=np.array([0.02, -0.03, 0.0, 0.0]),
    end_distance=np.array([0.01, 0.012, 0.0, 0.0]),
    bend=np.array([2.0, 0.84, 3.0, 3.0]),
    own_bend=np.array([2.1, 1.25, 3.0, 3.0]),
    status=("fine", "fine", "fine", "not converged"),
)


def test_the_error_is_signed_as_equation_17_and_split_in_two() -> None:
    np.testing.assert_allclose(FOUR.relative_error[:3], [0.01, -0.02, 0.0], atol=1e-15)
    np.testing.assert_allclose(FOUR.of_fit[:3], [0.002, -0.0201, 0.0], atol=1e-15)
    np.testing.assert_allclose(FOUR.of_path[:3], [0.008, 0.0001, 0.0], atol=1e-15)
    np.testing.assert_allclose(FOUR.of_fit + FOUR.of_path, FOUR.relative_error, atol=1e-15)


def test_rows_hold_their_columns() -> None:
    rows = FOUR.rows()
    names = ["a diagonal 1", "a diagonal 2", "b diagonal 1", "b diagonal 2"]
    assert [row.name for row in rows] == names
    assert rows[1].calculated == 4.9
    assert rows[1].relative_error == FOUR.relative_error[1]
    assert rows[1].patch == "a"
    assert rows[3].status == "not converged"
    assert math.isnan(rows[3].relative_error)


def test_the_distribution_counts_what_has_no_length_and_leaves_it_out() -> None:
    spread = distribution(FOUR)
    assert (spread.count, spread.without_length) == (4, 1)
    assert spread.mean == pytest.approx(-0.01 / 3)
    assert spread.mean_absolute == pytest.approx(0.01)
    assert spread.median_absolute == pytest.approx(0.01)
    assert spread.quantile_95 == pytest.approx(0.019)
    assert spread.largest == FOUR.row(1)
    assert spread.explanation == explain(FOUR.row(1), Unit.CM)
    assert spread.uncertainty == pytest.approx(1.25e-4)


def test_without_any_length_there_is_no_largest() -> None:
    none = distribution(replace(FOUR, calculated=np.full(4, np.nan)))
    assert none.without_length == 4
    assert none.largest is None
    assert math.isnan(none.mean_absolute)


def test_an_error_is_explained_by_the_fit_and_by_the_path() -> None:
    of_fit = explain(FOUR.row(1), Unit.CM)
    assert "Of -2.000%, -2.010% is the fit" in of_fit
    assert "up to 0.60 mm off the surface (0.30 mm inside on average, 0.12 mm at" in of_fit
    assert "laid on it is longer by that." in of_fit
    assert "radius is 8.4 mm on the surface and 12.5 mm on the atlas." in of_fit
    assert of_fit.endswith("none that is shorter, as far as the meshes can tell.")
    of_path = explain(FOUR.row(0), Unit.CM)
    assert "+0.800% is the path: the surface has a shorter one. On the atlas: fine" in of_path
    assert "0.20 mm outside on average" in of_path


def test_of_a_boundary_curve_there_is_no_path_to_explain() -> None:
    sides = replace(FOUR, physical=FOUR.laid, uncertainty=FOUR.laid_uncertainty)
    assert explain(sides.row(1), Unit.CM).endswith("and 12.5 mm on the atlas.")


def test_a_shorter_path_counts_beyond_the_doubt_of_both_lengths() -> None:
    assert FOUR.shorter_path.tolist() == [True, False, False, False]
    doubtful = replace(FOUR, laid_uncertainty=np.full(4, 0.08))
    assert not doubtful.shorter_path.any()
