import numpy as np
import pytest
from helpers.surfaces.random_patches import wild_patches

from bodymeasure import load_sample
from bodymeasure.bench.entrants.entrants import MESH_METHODS
from bodymeasure.bench.problems.patches import mild_patches
from bodymeasure.paper.tables.beyond import beyond_table, families, known_diagonals
from bodymeasure.paper.tables.named_methods import named_methods_table
from bodymeasure.paper.tables.table import Table


@pytest.fixture(scope="module")
def table() -> Table:
    nets = load_sample("female_average").control_points[::40]
    return beyond_table([known_diagonals("body", nets)], (2, 3, 8))


def test_known_diagonals_are_geodesics_inside(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 20, 1.0)
    known = known_diagonals("wild", nets)
    assert 5 < len(known.length) <= 20
    assert len(known.control_points) == len(known.length)
    chord = np.linalg.norm(known.control_points[:, 3, 3] - known.control_points[:, 0, 0], axis=1)
    assert (known.length > chord).all()


def test_more_functions_are_more_accurate(table: Table) -> None:
    rows = {(row["family"], row["functions"]): row for row in table.records}
    for family in (
        "RBF Wu C2, centers outside",
        "RBF Wu C10, centers outside",
        "polynomial collocation",
        "Ritz, u and v free",
    ):
        few, many = rows[family, 2], rows[family, 8]
        assert many["raw_median"] < 1e-3 * few["raw_median"]
        assert many["solved"] >= few["solved"]
        assert many["median"] < 1e-10


def test_every_patch_is_counted(table: Table) -> None:
    totals = {row["solved"] + row["failed"] for row in table.records}
    assert len(totals) == 1
    assert len(table.rows) == 3 * len(families())


@pytest.mark.slow
def test_each_method_has_its_errors_and_its_order() -> None:
    known = known_diagonals("mild", mild_patches(np.random.default_rng(1), 4, 0.3))
    counted: list[int] = []
    table = named_methods_table([known, known], (17, 33), counted.append)
    assert counted == [1, 2]
    rows = table.records
    assert {row["method"] for row in rows} >= set(MESH_METHODS) - {"pygeodesic exact"}
    assert {row["tried"] for row in rows} == {len(known.length)}
    by_method = {row["method"]: row for row in rows}
    for method in ("libigl exact", "potpourri3d edge flips", "unfolding [5]"):
        row = by_method[method]
        assert row["failures"] == 0
        assert 0.0 < row["error_33"] < row["error_17"] < 1e-3
        assert 1.5 < row["order"] < 2.7
    heat = by_method["libigl heat"]
    assert heat["error_33"] > 10.0 * by_method["libigl exact"]["error_33"]
    # Both sets are the same, and so are the figures, but for times.
    half = len(table.rows) // 2
    assert [row[:-1] for row in table.rows[:half]] == [row[:-1] for row in table.rows[half:]]
