"""The parts of paths that run along edges for a while."""

import numpy as np
import pytest
from helpers.body_space import body_of
from helpers.surfaces.cut_atlases import cut
from helpers.surfaces.grids import grid_atlas

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.contact import free_leg
from bodymeasure.geodesic.across.contact.pattern import FreePart, HeldPart, read_pattern
from bodymeasure.geodesic.across.contact.sliding_leg import solve_leg
from bodymeasure.geodesic.across.contact.solve import held_path
from bodymeasure.geodesic.across.pieces.budget import PATH, Budget
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.search import shortest_along
from bodymeasure.geodesic.across.search.sides import one_sided, seam_runs
from bodymeasure.geodesic.between import geodesic_between
from bodymeasure.geodesic.spaces.polygons import polygon_space
from bodymeasure.geodesic.status import Status


def test_polygons_are_straight_between_their_nodes() -> None:
    space = polygon_space(5)
    values = np.array([0.0, 1.0, -1.0, 3.0, 2.0, 0.5])
    times = np.linspace(0.0, 1.0, 23)
    place, slope, bend = space.matrices(times)
    np.testing.assert_allclose(place @ values, np.interp(times, space.nodes, values), atol=1e-14)
    np.testing.assert_allclose(slope[3] @ values, 5.0, rtol=1e-14)
    np.testing.assert_array_equal(bend, 0.0)


def over_the_bulge() -> tuple[Atlas, Neighbors, Route]:
    """A path along the lower edge of two patches, which bulges into them."""
    x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    net = np.stack([3 * x, y + 3 * (1 - y) * x * (1 - x), 0 * x], axis=-1)
    atlas = cut(net, (0.5,), (), turn=False)
    neighbors = Neighbors(atlas)
    (over,) = neighbors.over[0, 1]
    return (
        atlas,
        neighbors,
        Route((AtlasPoint(0, 0.0, 0.1), AtlasPoint(1, 1.0, 0.1)), (over,), (0.05,)),
    )


def test_free_and_held_parts_are_read_off_a_polygon() -> None:
    atlas, neighbors, route = over_the_bulge()
    parts = read_pattern(refine(atlas, route, polygon_space(32), 3.0))
    assert [type(part) for part in parts] == [FreePart, HeldPart, HeldPart, FreePart]
    first, *_, last = parts
    assert isinstance(first, FreePart)
    assert isinstance(last, FreePart)
    # On the side v = 0, the third of them.
    assert (first.slides, last.slides) == ((None, 2), (2, None))
    found = held_path(atlas, neighbors, refine(atlas, route, 8, 3.0), 1e-9, Budget(PATH))
    assert found is not None
    assert [piece.patch for piece in found.pieces] == [0, 0, 1, 1]
    assert len(found.crossings) == 1
    # Where the legs join it, they are tangential to the edge.
    leg = found.pieces[0]
    slope = leg.space.matrices([1.0])[1, 0] @ leg.values[1]
    assert slope == pytest.approx(0.0, abs=1e-9)
    assert leg.values[1, -1] == 0.0


def test_nothing_holds_a_path_that_would_rather_take_a_neighbor() -> None:
    atlas = grid_atlas(
        2,
        1,
        lambda x, y: np.stack(
            [x - 0.5 * np.sin(np.pi * y) * np.sin(np.pi * x / 2.0), y, 0 * x], -1
        ),
    )
    alone = Route((AtlasPoint(0, 0.95, 0.05), AtlasPoint(0, 0.95, 0.95)))
    refined = refine(atlas, alone, 8, 1.0)
    assert refined.held_nodes.any()
    assert held_path(atlas, Neighbors(atlas), refined, 1e-9, Budget(PATH)) is None


def test_an_exhausted_budget_leaves_held_paths_unsolved() -> None:
    atlas, neighbors, route = over_the_bulge()
    budget = Budget(0.0)
    assert held_path(atlas, neighbors, refine(atlas, route, 8, 3.0), 1e-9, budget) is None
    assert budget.cut_short
    budget = Budget(PATH)
    assert held_path(atlas, neighbors, refine(atlas, route, 8, 3.0), 1e-9, budget) is not None
    # Two legs on one patch each, of a few steps at the lowest degrees.
    assert 10_000.0 < PATH - budget.left < 1_000_000.0


@pytest.mark.slow
def test_legs_over_sharply_bent_patches_are_given_up_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    # The error of a leg over 15 patches of this wild body falls as a low power of the degree, so
    # that no degree is enough; the last one has 4,786 unknowns and took ten seconds.
    body = body_of(2.5 * np.random.default_rng(4).standard_normal(60))
    degrees: list[int] = []

    def noted(problem: RouteProblem, guess: Array, budget: Budget) -> RefinedPath | None:
        degrees.append(problem.space.size)
        return solve_leg(problem, guess, budget)

    monkeypatch.setattr(free_leg, "solve_leg", noted)
    path = geodesic_between(
        body,
        AtlasPoint(254, 0.7857538492437716, 0.9700710402217617),
        AtlasPoint(237, 0.6597066845311899, 0.08463262633371194),
    )
    assert path.status is Status.CONVERGED
    # The path that the search took before it gave such legs up.
    assert path.length == pytest.approx(0.6164704517328105, abs=1e-9)
    assert 32 in degrees
    assert max(degrees) == 32


def test_routes_along_seams_are_put_on_either_side() -> None:
    # The path runs along x = 1 over three squares, on the left, on the right, and on the left
    # again.
    atlas = grid_atlas(2, 3)
    neighbors = Neighbors(atlas)
    corners = [AtlasPoint(0, 1.0, 1.0), AtlasPoint(4, 0.0, 1.0)]
    goals = [AtlasPoint(4, 0.0, 0.0), AtlasPoint(2, 1.0, 0.0)]
    steps = [
        step
        for corner, goal in zip(corners, goals, strict=True)
        for step in neighbors.ways(corner, goal)[0]
    ]
    route = Route.of((AtlasPoint(0, 1.0, 0.3), AtlasPoint(2, 1.0, 0.6)), steps)
    refined = refine(atlas, route, 8, 3.0)
    runs = seam_runs(neighbors, refined)
    assert sum(run.last - run.first for run in runs) >= 2
    found = one_sided(neighbors, refined.route, runs)
    assert {way.patches for way in found} == {(0, 1, 2), (3, 4, 5)}


def test_a_path_beside_a_ridge_is_the_shorter_of_those_on_its_sides() -> None:
    # The surface rises a little more on one side of the ridge over x = 1: there are shortest paths
    # from end to end on both sides, of nearly one length, and a search may begin on either.
    def place(x: Array, y: Array) -> Array:
        ridge = np.where(np.isclose(x, 1.0), 0.1 * np.sin(np.pi * y / 3.0), 0.0)
        return np.stack([x, y, ridge + 0.1 * x], axis=-1)

    atlas = grid_atlas(2, 3, place)
    neighbors = Neighbors(atlas)
    found = []
    for first, u in ((0, 1.0), (3, 0.0)):
        ends = AtlasPoint(first, u, 0.0), AtlasPoint(first + 2, u, 1.0)
        crossings = [
            crossing
            for patch in (first, first + 1)
            for side in range(4)
            for crossing in neighbors.over.get((patch, side), ())
            if crossing.to_patch == patch + 1
        ]
        route = Route(ends, tuple(crossings), (abs(u - 0.05),) * 2)
        found.append(shortest_along(atlas, neighbors, [route], 3.0).part.length.corrected)
    np.testing.assert_allclose(found[0], found[1], rtol=1e-9)
