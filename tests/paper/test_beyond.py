import numpy as np
import pytest
from helpers.surfaces.random_patches import wild_patches

from bodymeasure import load_sample
from bodymeasure.paper.tables.beyond import beyond_table, families, known_diagonals
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
