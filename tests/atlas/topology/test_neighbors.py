import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import evaluate


@pytest.fixture
def turned() -> Atlas:
    """Six patches in a grid, two of which are turned around."""
    atlas = grid_atlas(2, 3, lambda x, y: np.stack([x, y, np.sin(2 * x + y * y)], axis=-1))
    index = atlas.index.copy()
    index[1] = np.rot90(index[1])
    index[4] = index[4, ::-1].T
    return Atlas(atlas.points, index, Unit.CM)


def position(atlas: Atlas, place: AtlasPoint) -> np.ndarray:
    return np.asarray(evaluate(atlas.control_points[place.patch], (place.u, place.v)))


@pytest.mark.parametrize(
    ("place", "count"),
    [
        (AtlasPoint(0, 0.3, 0.4), 1),
        (AtlasPoint(0, 0.3, 0.0), 1),
        (AtlasPoint(0, 0.3, 1.0), 2),
        (AtlasPoint(0, 1.0, 0.7), 2),
        (AtlasPoint(0, 1.0, 1.0), 4),
        (AtlasPoint(0, 1.0, 0.0), 2),
    ],
)
def test_all_places_of_a_point(turned: Atlas, place: AtlasPoint, count: int) -> None:
    same = Neighbors(turned).same(place)
    assert same[0] == place
    assert len({found.patch for found in same}) == len(same) == count
    for found in same:
        np.testing.assert_allclose(position(turned, found), position(turned, place), atol=1e-15)


def test_two_ways_about_an_inner_corner_and_one_at_the_boundary(turned: Atlas) -> None:
    neighbors = Neighbors(turned)
    inner = AtlasPoint(0, 1.0, 1.0)
    opposite = next(place for place in neighbors.same(inner) if place.patch == 4)
    ways = neighbors.ways(inner, opposite)
    assert sorted([step.place.patch for step in way] for way in ways) == [[1, 4], [3, 4]]
    for way in ways:
        for step in way:
            np.testing.assert_allclose(
                position(turned, step.place), position(turned, inner), atol=1e-15
            )
    rim = AtlasPoint(0, 1.0, 0.0)
    (way,) = neighbors.ways(rim, neighbors.same(rim)[1])
    assert [step.place.patch for step in way] == [3]


def test_a_patch_can_be_its_own_neighbor() -> None:
    ring = grid_atlas(1, 1, lambda x, y: np.stack([np.sin(6 * x), np.cos(6 * x), y], axis=-1))
    index = ring.index.copy()
    index[0, 3] = index[0, 0]
    neighbors = Neighbors(Atlas(ring.points, index, Unit.CM))
    (step,) = neighbors.steps(AtlasPoint(0, 1.0, 0.25))
    assert (step.along, step.place) == (0.25, AtlasPoint(0, 0.0, 0.25))


def test_collapsed_edges_lead_nowhere() -> None:
    atlas = grid_atlas(1, 2)
    index = atlas.index.copy()
    index[0, 0] = index[0, 0, 0]
    neighbors = Neighbors(Atlas(atlas.points, index, Unit.CM))
    assert neighbors.same(AtlasPoint(0, 0.0, 0.5)) == [AtlasPoint(0, 0.0, 0.5)]
