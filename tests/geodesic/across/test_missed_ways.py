"""Shorter ways that were missed, and searches that took far too long."""

import numpy as np
import pytest
from helpers.body_space import body_of
from helpers.many_patches import SURFACES

import bodymeasure as bm
from bodymeasure.atlas import AtlasPoint
from bodymeasure.geodesic.across.pieces.budget import OVERDRAFT
from bodymeasure.geodesic.across.poles import leg


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
    monkeypatch.setattr(leg, "PATH", 4e5)
    path = bm.geodesic_between(body, *round_a_bump(), on_failure="status")
    assert path.status is bm.Status.CUT_SHORT
    assert path.error_estimate < 1e-6 * path.length
    # At the first degree this one is not known well enough.
    ends = (
        AtlasPoint(300, 0.8447291006744885, 0.785240402698712),
        AtlasPoint(143, 0.4472888237709147, 0.7128909397298278),
    )
    monkeypatch.setattr(leg, "PATH", -OVERDRAFT)
    path = bm.geodesic_between(body, *ends, on_failure="status")
    assert path.status is bm.Status.OUT_OF_BUDGET
    assert np.isnan(path.length)
    with pytest.raises(bm.ConvergenceError, match="used up its budget"):
        bm.geodesic_between(body, *ends)


# Pairs whose shortest path runs along a route along which there is another one, which the first
# start led to; the shortest known length, and that of the other path.
TWO_ON_A_ROUTE = (
    (
        None,
        AtlasPoint(276, 0.6803417830461307, 0.7852739522088118),
        AtlasPoint(156, 0.9409580823095943, 0.3757000414797116),
        0.6907144900,  # 0.6907600664
    ),
    (
        "female_heavy",
        AtlasPoint(64, 0.9916767169901963, 0.7236762546507963),
        AtlasPoint(353, 0.8088438090346699, 0.15286502314567285),
        1.0845569045,  # 1.0845677437
    ),
    (
        "female_full_bust",
        AtlasPoint(327, 0.3416340099741699, 0.8240017986428428),
        AtlasPoint(265, 0.23064890373883828, 0.871013711841216),
        0.5256566097,  # 0.5256571105
    ),
)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "start", "end", "length"), TWO_ON_A_ROUTE)
def test_the_shorter_one_of_two_paths_along_one_route_is_found(
    name: str | None, start: AtlasPoint, end: AtlasPoint, length: float
) -> None:
    coefficients = 0.9 * np.random.default_rng(2026).standard_normal(60)
    body = bm.load_sample(name) if name else body_of(coefficients)
    for ends in ((start, end), (end, start)):
        path = bm.geodesic_between(body, *ends)
        assert path.length <= length + 2e-10
        assert path.error_estimate < 1e-9


def test_a_path_leaves_a_seam_that_holds_it_to_the_better_side() -> None:
    body = body_of(np.random.default_rng(1001).standard_normal(60))
    # The end is a corner on the seam of two patches, along which the path comes.
    ends = AtlasPoint(74, 0.8, 0.25), AtlasPoint(360, 1.0, 1.0)
    for start, end in (ends, ends[::-1]):
        path = bm.geodesic_between(body, start, end)
        # On the other patch it is 0.4519315311.
        assert path.length <= 0.4519310044 + 2e-10
        assert path.error_estimate < 1e-9


@pytest.mark.slow
def test_a_path_is_not_held_by_changing_sides_of_a_seam_back_and_forth() -> None:
    body = bm.load_sample("female_average")
    ends = (
        AtlasPoint(360, 0.27145160453010153, 0.8796511733349222),
        AtlasPoint(208, 0.06421443731219101, 0.679181533021365),
    )
    for start, end in (ends, ends[::-1]):
        path = bm.geodesic_between(body, start, end)
        # With pieces of no length on either side of a seam it is 0.6821118363.
        assert path.length <= 0.68211136299 + path.error_estimate
        assert path.error_estimate < 1e-9
        assert path.patches.count(361) == 1


@pytest.mark.parametrize("u", [0.0, 1e-3])
def test_a_path_over_a_ridge_that_is_at_rest_gives_way_to_one_beside_it(u: float) -> None:
    # Round an ellipsoid's sharpest rim, from its longest axis to the middle one, the rim is a
    # geodesic along a seam, and longer than the curves that lead over the flat side.
    body = SURFACES["ellipsoid"]()
    start, end = AtlasPoint(0, u, 0.0), AtlasPoint(5, 0.0, 1.0)
    path = bm.geodesic_between(body, start, end)
    assert path.status is bm.Status.CONVERGED
    first, last = (float(np.arctan2(y / 0.7, x)) for x, y, _ in map(body.position, (start, end)))
    angle = np.linspace(first, last, 4001)
    lengths = []
    for height in np.linspace(0.0, 0.2, 41):
        up = height * np.sin(np.pi * (angle - angle[0]) / np.ptp(angle))
        curve = np.array(
            [np.cos(up) * np.cos(angle), 0.7 * np.cos(up) * np.sin(angle), 0.4 * np.sin(up)]
        )
        lengths.append(np.linalg.norm(np.diff(curve, axis=1), axis=0).sum())
    assert lengths[0] - min(lengths) > 1e-4
    # The best of these curves is nearly the shortest one.
    assert min(lengths) - 1e-4 < path.length < min(lengths)
    back = bm.geodesic_between(body, end, start)
    assert back.length == pytest.approx(path.length, abs=path.error_estimate + back.error_estimate)
