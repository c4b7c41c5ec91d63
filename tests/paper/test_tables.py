"""Tables made from known results, so that every figure is known."""

import csv
import io
import math
from dataclasses import fields
from typing import Any

import numpy as np
import pytest

from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.data.random_patches import READINGS, RandomPatches
from bodymeasure.paper.tables.aims import accuracy_bars
from bodymeasure.paper.tables.readings import closest_table, events_table
from bodymeasure.paper.tables.spreads import distribution_table, roots_table
from bodymeasure.paper.tables.statistics import signed_difference
from bodymeasure.paper.tables.table import Column, Table, plain, to_csv, to_record
from bodymeasure.paper.tables.tables_3_and_4 import (
    ReadingResult,
    table_3,
    table_4,
    truth_table,
)

NAN = math.nan


def comparison(**values: Any) -> Comparison:
    """Two sets of two patches, with some of the values given."""
    told: dict[str, Any] = {
        "inside_length": [1.03, 1.01, NAN, 2.04],
        "all_length": [1.03, 1.0, 9.0, 2.04],
        "collocation_point": [0.5, 0.45, NAN, 0.5],
        "roots": [9, 7, 8, 9],
        "roots_inside": [1, 0, 0, 2],
        "degenerate": [0, 1, 0, 0],
        "ritz_length": [1.0, 1.0, 1.5, 2.0],
        "ritz_order": [5, 6, 16, 4],
        "ritz_stopped": [True, True, False, True],
        "ritz_inside": [True, False, True, True],
        "true_length": [1.0, 1.02, NAN, 1.99],
        "true_error": [1e-9, 1e-9, math.inf, 1e-9],
        "turns_back": [False, False, False, False],
        "along_edge": [False, True, False, False],
        "rbf_seconds": [0.01, 0.02, 0.04, 0.01],
        "ritz_seconds": [0.02, 0.02, 0.02, 0.03],
        **values,
    }
    return Comparison(**{field.name: np.array(told[field.name]) for field in fields(Comparison)})


def result(reading: int = 1, **values: Any) -> ReadingResult:
    data = RandomPatches(np.zeros((2, 2, 4, 4, 3)), folded=3, intersecting=2)
    return ReadingResult(READINGS[reading], data, comparison(**values))


def rows(table: Table) -> list[dict[str, Any]]:
    return [dict(row) for row in to_record(table)["rows"]]


def test_equation_15_keeps_its_sign() -> None:
    np.testing.assert_allclose(
        signed_difference(np.array([1.03, 0.98, NAN]), np.ones(3)), [0.03, -0.02, NAN], rtol=1e-12
    )


def test_table_4_counts_what_failed_and_drops_nothing() -> None:
    one, two, total = rows(table_4(result(), "inside"))
    assert (one["patches"], one["compared"], one["failed"]) == (2, 2, 0)
    assert (two["patches"], two["compared"], two["failed"]) == (2, 1, 1)
    assert (total["patches"], total["compared"], total["failed"]) == (4, 3, 1)
    assert one["mean_loss"] == pytest.approx(0.02)
    assert two["mean_loss"] == pytest.approx(0.02)
    assert total["median_loss"] == pytest.approx(0.02)
    assert one["rms"] == pytest.approx(math.sqrt((0.03**2 + 0.01**2) / 2))
    # (16): Ritz's time by that of the radial functions.
    assert one["mean_time_ratio"] == pytest.approx(1.5)
    assert [one["published_loss"], two["published_loss"]] == [0.0289, 0.0301]
    assert total["published_loss"] is None


def test_table_4_of_all_solutions_is_ruined_by_a_far_one() -> None:
    _, two, _ = rows(table_4(result(), "all"))
    assert (two["compared"], two["failed"]) == (2, 0)
    assert two["mean_loss"] == pytest.approx((5.0 + 0.02) / 2)


def test_a_loss_below_zero_shows_in_the_root_mean_square() -> None:
    shorter = result(inside_length=[0.97, 0.99, 1.4, 1.9])
    assert rows(table_4(shorter, "inside"))[0]["rms"] < 0.0


def test_a_set_without_a_solution_has_no_mean() -> None:
    _, two, _ = rows(table_4(result(inside_length=[1.0, 1.0, NAN, NAN]), "inside"))
    assert (two["compared"], two["mean_loss"], two["rms"]) == (0, None, None)


def test_table_3_stands_beside_the_published_rows() -> None:
    found = rows(table_3(result()))
    assert [row["published_ritz_length"] for row in found] == [r[2] for r in published.TABLE_3]
    assert found[0]["rbf_error"] == pytest.approx(0.03)
    assert found[1]["ritz_error"] == pytest.approx(1.0 / 1.02 - 1.0)
    assert (found[2]["rbf_length"], found[2]["true_length"]) == (None, None)


def test_the_truth_tells_who_erred() -> None:
    inside, every, ritz = rows(truth_table(result()))
    assert (inside["compared"], inside["not_compared"]) == (3, 1)
    # Patch 2: 1.01 against 1.02, Ritz 1.00; patches 1 and 4: Ritz is nearer.
    assert (inside["nearer"], inside["of"]) == (1, 3)
    assert (ritz["nearer"], ritz["of"]) == (2, 3)
    assert every["least"] == pytest.approx(1.0 / 1.02 - 1.0)


def test_aims_that_were_missed_are_told() -> None:
    lengths = [1.0001, 1.0001, NAN, NAN]
    far, none, body = rows(accuracy_bars(result(inside_length=lengths), 0.0021))
    assert (far["found"], far["met"]) == (pytest.approx(1e-4), False)
    # Where there are no data, there is no answer.
    assert (none["found"], none["met"]) == (None, None)
    assert (body["most"], body["met"]) == (0.002, False)
    first, second, body = rows(accuracy_bars(result(), 0.0019))
    assert (first["met"], second["met"], body["met"]) == (True, True, True)
    # A third of the paper's mean.
    assert first["least"] == pytest.approx(0.0307 / 3.0, abs=1e-4)


def test_events_are_counted() -> None:
    counts = {row["what"]: row["grid_0_6"] for row in rows(events_table([result()]))}
    assert counts == {
        "patches": 4,
        "drawn and refused: folded": 3,
        "drawn and refused: cut through themselves": 2,
        "RBF: real solutions a patch, mean": 8.25,
        "RBF: real solutions a patch, most": 9,
        "RBF: of these inside, mean": 0.75,
        "RBF: none inside at t = 1/2": 2,
        "RBF: collocation point moved": 1,
        "RBF: none inside at any point": 1,
        "RBF: no solution at all": 0,
        "RBF: determinant zero": 1,
        "Ritz: not under the bound": 1,
        # The last: 2.0 against 1.99.
        "Ritz: stopped too early": 1,
        "Ritz: path leaves the patch": 1,
        "truth: turns back in u": 0,
        "truth: runs along an edge": 1,
        "truth: not known": 1,
    }


def test_the_nearest_reading_comes_first() -> None:
    near = result(1, inside_length=[1.03, 1.03, 1.545, 2.06])
    far = result(0)
    table = rows(closest_table([far, near]))
    assert [row["reading"] for row in table] == ["grid 0.6", "grid 1"]
    assert table[0]["off"] == pytest.approx(abs(0.03 - published.MEAN_LOSS))
    # One of 1, 1, 1.5 and 2 lies among the paper's.
    assert table[0]["in_range"] == 0.25


def test_distributions_and_solutions() -> None:
    first = rows(distribution_table([result()]))[0]
    assert (first["count"], first["quantile_0"]) == (3, pytest.approx(0.01))
    assert first["quantile_100"] == pytest.approx(0.03)
    solutions = rows(roots_table([result()]))
    assert [row["real_0"] for row in solutions] == [0] * 7 + [1, 1, 2]
    assert [row["inside_0"] for row in solutions][:3] == [2, 1, 1]


def test_values_for_files_are_plain() -> None:
    assert plain(np.float64(0.5)) == 0.5
    assert plain(np.array(3)) == 3
    assert plain(np.nan) is None
    assert plain(-math.inf) is None
    assert plain(np.bool_(True)) is True
    assert plain("a") == "a"


def test_csv_holds_every_value_that_the_columns_give() -> None:
    columns = (
        Column("a", "A", "count", lambda item: item[0]),
        Column("b", "B", "seconds", lambda item: item[1], is_timing=True),
    )
    table = Table.of("some", "Some", columns, [(1, np.float64(0.1)), (2, NAN)], "A note.")
    assert (table.rows, table.notes) == (((1, 0.1), (2, None)), ("A note.",))
    lines = list(csv.DictReader(io.StringIO(to_csv([table]).decode(), newline="")))
    assert [(r["table"], r["row"], r["column"], r["value"], r["timing"]) for r in lines] == [
        ("some", "0", "a", "1", "0"),
        ("some", "0", "b", "0.1", "1"),
        ("some", "1", "a", "2", "0"),
        ("some", "1", "b", "", "1"),
    ]
