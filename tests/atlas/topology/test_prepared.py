"""What is prepared of an atlas is kept by its contents, of a few atlases."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

import bodymeasure as bm
from bodymeasure.atlas.prepared import MOST, prepared
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.geodesic.across.routes.graph import patch_graph

made: list[bm.Atlas] = []


@prepared
def counted(atlas: bm.Atlas, part: int = 0) -> list[int]:
    made.append(atlas)
    return [len(atlas), part]


def plane(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.stack([x, y, 0.0 * x], axis=-1)


@pytest.fixture
def atlas() -> bm.Atlas:
    made.clear()
    # No other test uses an atlas of this size.
    return replace(grid_atlas(3, 2, plane), unit=bm.Unit.MM)


def test_atlases_of_one_geometry_share_what_is_prepared(atlas: bm.Atlas) -> None:
    first = counted(atlas)
    for other in (
        atlas,
        replace(atlas, name="another", landmarks={"here": bm.AtlasPoint(0, 0.5, 0.5)}),
        pickle.loads(pickle.dumps(atlas)),
    ):
        assert counted(other) is first
    assert counted(atlas, 1) == [6, 1]
    assert counted(atlas, part=1) == [6, 1]
    assert counted(atlas) is first


def test_other_patches_seams_and_units_share_nothing(atlas: bm.Atlas) -> None:
    first = counted(atlas)
    cut = bm.Atlas.from_control_points(atlas.control_points, atlas.unit)
    assert np.array_equal(cut.control_points, atlas.control_points)
    for other in (replace(atlas, points=2.0 * atlas.points), replace(atlas, unit=bm.Unit.CM), cut):
        assert counted(other) is not first
    assert patch_graph(cut).mesh.vertex.max() > patch_graph(atlas).mesh.vertex.max()


def test_what_is_kept_is_bounded(atlas: bm.Atlas) -> None:
    atlas = replace(atlas, points=3.0 * atlas.points)
    counted(atlas)
    for number in range(MOST - 1):
        counted(replace(atlas, points=atlas.points + 1.0 + number))
    counted(atlas)
    assert len(made) == MOST
    # The atlas was used last, so that the oldest of the others goes first.
    counted(replace(atlas, points=atlas.points - 1.0))
    counted(atlas)
    assert len(made) == MOST + 1
    for number in range(MOST):
        counted(replace(atlas, points=atlas.points - 2.0 - number))
    counted(atlas)
    assert len(made) == 2 * MOST + 2


def test_what_all_share_cannot_be_changed(atlas: bm.Atlas) -> None:
    with pytest.raises(ValueError, match="read-only"):
        edges_of(atlas).edge[0, 0] = 7
