"""The tables for Table 5, made from comparisons with known values."""

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.paper.data import published
from bodymeasure.paper.surface.curves import diagonal_curves
from bodymeasure.paper.surface.surface_comparison import Comparison
from bodymeasure.paper.surface.table5 import Table5
from bodymeasure.paper.tables.aims import speed_bars
from bodymeasure.paper.tables.speed import OUR_METHODS, OUR_RITZ
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.table_5 import (
    body_distribution,
    by_two_functions,
    curve_tables,
    spread_of_table_5,
    table_5,
)

PHYSICAL = np.array([0.13, 0.0625, 0.1025, 0.0875, 0.2])
ERROR = np.array([0.001, -0.002, 0.0, 0.001, np.nan])
DEFAULT, LOOSE = (name for name, _ in OUR_METHODS)


def comparison(physical: Array, error: Array) -> Comparison:
    zeros = np.zeros(len(physical))
    return Comparison(
        unit=Unit.M,
        patch=tuple("abcde")[: len(physical)],
        place=("diagonal 1", "diagonal 2", "diagonal 1", "diagonal 2", "diagonal 1"),
        calculated=physical * (1.0 + error),
        physical=physical,
        uncertainty=1e-6 * physical,
        laid=physical,
        laid_uncertainty=zeros,
        distance=zeros + 1e-4,
        offset=zeros,
        end_distance=zeros,
        bend=zeros + 0.1,
        own_bend=zeros + 0.1,
        status=("",) * len(physical),
    )


FOUND = Table5(comparison(PHYSICAL, ERROR), comparison(PHYSICAL, 0.0 * ERROR - 0.003))
TWO = comparison(PHYSICAL, np.array([0.01, 0.02, np.nan, 0.04, 0.01]))


def test_the_papers_form_is_in_centimeters_with_two_functions_beside() -> None:
    rows = table_5(FOUND, TWO).records
    assert [row["curve"] for row in rows] == [
        "a diagonal 1",
        "b diagonal 2",
        "c diagonal 1",
        "d diagonal 2",
    ]
    assert [row["physical"] for row in rows] == pytest.approx([13.0, 6.25, 10.25, 8.75])
    assert rows[0]["calculated"] == pytest.approx(13.013)
    assert [row["error"] for row in rows] == pytest.approx(ERROR[:4].tolist())
    assert rows[1]["two_functions"] == pytest.approx(6.25 * 1.02)
    assert (rows[2]["two_functions"], rows[2]["two_functions_error"]) == (None, None)
    assert [row["published_calculated"] for row in rows] == [
        row.calculated for row in published.TABLE_5
    ]


def test_the_spread_counts_what_has_no_length_and_explains_the_largest() -> None:
    table = spread_of_table_5(FOUND, TWO)
    diagonals, two, boundary, paper = table.records
    assert (diagonals["count"], diagonals["without_length"]) == (5, 1)
    assert diagonals["mean_absolute"] == pytest.approx(0.001)
    assert (diagonals["largest"], diagonals["which"]) == (pytest.approx(-0.002), "b diagonal 2")
    assert (two["without_length"], two["largest"]) == (1, pytest.approx(0.04))
    assert boundary["mean"] == pytest.approx(-0.003)
    # The four errors that the paper prints, with the signs that its lengths have.
    assert paper["mean_absolute"] == pytest.approx(0.008, abs=1e-5)
    assert (paper["largest"], paper["which"]) == (pytest.approx(-0.0106, abs=1e-4), "data 2")
    assert "Largest of the diagonals, b diagonal 2: Of -0.200%" in table.notes[0]


def test_files_hold_every_curve_and_the_chart_every_error() -> None:
    diagonals, boundary = (table.records for table in curve_tables(FOUND, TWO))
    assert [row["physical"] for row in diagonals] == pytest.approx((100.0 * PHYSICAL).tolist())
    assert diagonals[4]["calculated"] is None
    assert diagonals[0]["two_functions"] == pytest.approx(13.13)
    assert {row["two_functions"] for row in boundary} == {None}
    shown = {row["difference"]: row for row in body_distribution("body", FOUND, TWO).records}
    assert shown["diagonals"]["count"] == 4
    assert shown["diagonals"]["quantile_100"] == pytest.approx(0.002)
    assert shown["boundary curves"]["quantile_0"] == pytest.approx(0.003)


@pytest.mark.slow
def test_two_functions_are_exact_on_plane_patches_along_both_diagonals() -> None:
    """The path is straight whatever its speed; the patches are sheared, so diagonals differ."""

    def sheared(x: Array, y: Array) -> Array:
        return np.stack([0.1 * x + 0.04 * y, 0.07 * y, 0.3 + 0.02 * x], axis=-1)

    atlas = grid_atlas(2, 1, sheared)
    curves = diagonal_curves(atlas)
    ends = curves.points[:, -1] - curves.points[:, 0]
    chord = np.linalg.norm(ends, axis=-1)
    assert np.ptp(chord) > 0.1 * chord.mean()
    diagonals = Comparison(
        unit=atlas.unit,
        patch=curves.patch,
        place=curves.place,
        **dict.fromkeys(
            ("calculated", "physical", "uncertainty", "laid", "laid_uncertainty", "distance"), chord
        ),
        **dict.fromkeys(("offset", "end_distance", "bend", "own_bend"), chord),
        status=curves.status,
    )
    found = by_two_functions(diagonals, atlas, 1)
    np.testing.assert_allclose(found.calculated, chord, rtol=1e-12)


def speeds(default: tuple[float, float, float], loose: tuple[float, float, float]) -> Table:
    """Error at 90 %, and times as fast as the paper and as two functions, of both our methods."""
    columns = ("method", "solved", "median", "nine_in_ten", "seconds", "than_paper", "than_two")
    rows = [(OUR_RITZ, 9, 1e-7, 1e-5, 1e-2, 12.5, 2.0)]
    for name, (error, paper, two) in ((DEFAULT, default), (LOOSE, loose)):
        rows.append((name, 8, 1e-9, error, 0.125 / paper, paper, two))
    return Table("speed_x", "Time a patch: some", tuple(Column(c, c) for c in columns), tuple(rows))


@pytest.mark.parametrize(
    ("default", "loose", "method", "met"),
    [
        ((1e-9, 1100.0, 60.0), (1e-6, 2000.0, 70.0), LOOSE, True),
        # This one is too inaccurate, so that the slower one counts.
        ((1e-9, 900.0, 60.0), (1e-4, 2000.0, 70.0), DEFAULT, False),
        # It is fast compared with the paper, but not with two functions.
        ((1e-9, 1100.0, 40.0), (1e-6, 1200.0, 49.0), LOOSE, False),
        ((1e-4, 1100.0, 60.0), (1e-4, 2000.0, 70.0), None, False),
    ],
)
def test_speed_counts_only_at_the_accuracy_of_ritz(
    default: tuple[float, float, float],
    loose: tuple[float, float, float],
    method: str | None,
    met: bool,
) -> None:
    (row,) = speed_bars([speeds(default, loose)]).records
    assert (row["patches"], row["method"], row["met"]) == ("some", method, met)
