"""Shorter ways that were missed, and searches that took far too long."""

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.atlas import AtlasPoint
from bodymeasure.geodesic.across.search import search


def round_a_bump() -> tuple[AtlasPoint, AtlasPoint]:
    """Two points of a body; the exact path over a mesh of six segments is on the wrong side."""
    return (
        AtlasPoint(8, 0.3507371832140258, 0.6665409948765659),
        AtlasPoint(158, 0.5178486597756301, 0.8297537687017275),
    )


def test_a_path_on_the_other_side_of_a_bump_is_found() -> None:
    path = bm.geodesic_between(bm.load_sample("female_average"), *round_a_bump())
    assert path.status is bm.Status.CONVERGED
    # On the wrong side it is 1.1467503.
    assert path.length == pytest.approx(1.1465930817, abs=1e-9)


def test_what_runs_out_of_its_budget_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    body = bm.load_sample("female_average")
    for budget, status in ((1.0, bm.Status.OUT_OF_BUDGET), (4e5, bm.Status.CUT_SHORT)):
        monkeypatch.setattr(search, "PATH", budget)
        path = bm.geodesic_between(body, *round_a_bump(), on_failure="status")
        assert path.status is status
        assert path.error_estimate < 1e-6 * path.length or np.isnan(path.length)
    monkeypatch.setattr(search, "PATH", 1.0)
    with pytest.raises(bm.ConvergenceError, match="used up its budget"):
        bm.geodesic_between(body, *round_a_bump())
