import numpy as np
import pytest
from helpers.command_line import part_of_a_body
from helpers.surfaces.quad_grids import arc_net, grid_mesh, hilly_net, spline_atlas

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.geodesic import WU_C2, RBFCollocation
from bodymeasure.measure import boundary_lengths, diagonals
from bodymeasure.paper.data import published
from bodymeasure.paper.surface.source_mesh import load_source_mesh
from bodymeasure.paper.surface.surface_comparison import Comparison
from bodymeasure.paper.surface.table5 import Table5, compare_with_surface, table5
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import QuadMesh

NET = hilly_net(8, 9)
MESH = grid_mesh(NET)
# The patches are exactly the mesh's limit surface, two quads inside its boundary.
ATLAS = spline_atlas(NET, margin=2)


def test_an_atlas_that_is_the_surface_differs_by_what_the_meshes_are_off() -> None:
    table = compare_with_surface(ATLAS, MESH)
    assert len(table.diagonals) == 2 * len(ATLAS) == 24
    # 3 by 4 patches share most of their sides.
    assert len(table.boundary) == 4 * 4 + 3 * 5
    for comparison in (table.diagonals, table.boundary):
        error = np.abs(comparison.relative_error)
        assert error.max() < 3e-5
        assert (error * comparison.physical <= comparison.uncertainty + 1e-9).mean() > 0.9
        assert np.abs(comparison.of_path).max() < 3e-5
        # The rest is due to the sag of the finest mesh.
        assert comparison.distance.max() < 1e-3
        assert comparison.end_distance.max() < 1e-7
    np.testing.assert_array_equal(table.diagonals.calculated, diagonals(ATLAS).length.ravel())
    own = boundary_lengths(ATLAS).length.ravel()
    assert set(table.boundary.calculated) <= set(own)


def test_an_atlas_outside_the_surface_is_longer_by_the_angle_times_the_distance() -> None:
    """Cylinders on near-circular arcs of radii 1 and 1 + s; lengths differ around the axis."""
    s = 1e-3
    net = arc_net(11, 12)
    atlas = spline_atlas(net * [1.0 + s, 1.0, 1.0 + s], margin=3)
    table = compare_with_surface(atlas, grid_mesh(net))
    round_axis, along_axis = 2.0 * np.pi / 24.0, 0.3
    share = round_axis**2 / (round_axis**2 + along_axis**2)
    for comparison, errors in ((table.diagonals, [s * share]), (table.boundary, [0.0, s])):
        error = comparison.relative_error
        nearest = np.abs(error[:, None] - errors).min(axis=1)
        assert nearest.max() < 0.03 * s
        np.testing.assert_allclose(comparison.of_fit, error, rtol=0, atol=0.03 * s)
        assert not comparison.shorter_path.any()
        # The finest mesh sags below the surface by a twentieth of the distance.
        np.testing.assert_allclose(np.abs(comparison.offset), s, rtol=0.1)
        np.testing.assert_allclose(comparison.distance, s, rtol=0.1)
        np.testing.assert_allclose(comparison.end_distance, s, rtol=0.01)


def test_diagonals_without_a_length_are_counted_and_still_measured_on_the_surface() -> None:
    """With two functions the solver gives no diagonal a length, since they are too few."""
    table = compare_with_surface(ATLAS, MESH, method=RBFCollocation(WU_C2, 2), rows=6)
    spread, boundary = table.distributions()
    assert (spread.count, spread.without_length) == (6, 6)
    assert spread.largest is None
    assert np.isnan(table.diagonals.relative_error).all()
    assert (table.diagonals.uncertainty < 1e-3 * table.diagonals.physical).all()
    assert table.in_the_papers_form() == ()
    assert boundary.without_length == 0


def test_rows_are_chosen_by_the_seed() -> None:
    def names(seed: int) -> list[str]:
        table = compare_with_surface(ATLAS, MESH, rows=5, seed=seed)
        return [row.name for row in (*table.diagonals.rows(), *table.boundary.rows())]

    assert len(names(3)) == 10
    assert names(3) == names(3)
    assert names(3) != names(4)


def test_a_mesh_in_another_unit_is_refused() -> None:
    with pytest.raises(InputError, match=r"off the mesh's limit surface.*in the same unit"):
        compare_with_surface(ATLAS, QuadMesh(100.0 * MESH.vertices, MESH.quads), rows=3)
    with pytest.raises(InputError, match="rows is 0; expected at least 1"):
        compare_with_surface(ATLAS, MESH, rows=0)
    with pytest.raises(InputError, match="'paraboloid' was not fitted to a mesh"):
        table5("paraboloid")


def test_the_papers_four_rows_are_chosen_by_length_alone() -> None:
    physical = np.array([0.0875, 0.0876, 0.1025, 0.0626, 0.2, 0.1299, 0.0874])
    error = np.array([0.3, 0.0, 0.2, 0.0, 0.0, -0.5, np.nan])
    zeros = np.zeros(7)
    comparison = Comparison(
        unit=Unit.M,
        patch=tuple("abcdefg"),
        place=("diagonal 1",) * 7,
        calculated=physical * (1.0 + error),
        physical=physical,
        uncertainty=zeros,
        laid=physical,
        laid_uncertainty=zeros,
        distance=zeros,
        offset=zeros,
        end_distance=zeros,
        bend=zeros,
        own_bend=zeros,
        status=("",) * 7,
    )
    chosen = Table5(comparison, comparison).in_the_papers_form()
    assert [printed for printed, _ in chosen] == list(published.TABLE_5)
    assert [row.patch for _, row in chosen] == ["f", "d", "c", "a"]


def test_the_published_errors_are_those_of_the_published_lengths_but_for_the_sign() -> None:
    for row in published.TABLE_5:
        error = (row.calculated - row.physical) / row.physical
        assert abs(row.relative_error) == pytest.approx(abs(error), abs=6e-5)


@pytest.mark.slow
def test_a_quick_look_at_a_mannequin() -> None:
    table = table5("female_average", rows=4, seed=1)
    spread, boundary = table.distributions()
    assert spread.count == boundary.count == 4
    assert spread.without_length == 0
    assert 1e-5 < spread.mean_absolute < 2e-3
    assert spread.uncertainty < 2e-4
    assert len(table.in_the_papers_form()) == 4
    atlas = load_sample("female_average")
    assert all(row.patch in atlas.patch_names for row in table.diagonals.rows())


@pytest.mark.slow
def test_diagonals_of_half_a_trunk_and_an_arm_are_right_to_a_five_hundredth() -> None:
    # `bodymeasure paper` prints the same of the whole body.
    part, (mesh, _) = part_of_a_body(0, 48), load_source_mesh("female_average")
    table = compare_with_surface(part, mesh, processes=2)
    spread, boundary = table.distributions()
    assert (spread.count, spread.without_length) == (96, 0)
    assert spread.mean_absolute < 0.002
    # The meshes give lengths a hundred times more accurately than the atlas.
    assert spread.uncertainty < 0.01 * spread.mean_absolute
    assert (table.diagonals.uncertainty < 5e-4 * table.diagonals.physical).all()
    assert spread.largest is not None
    assert abs(spread.largest.relative_error) < 0.01
    assert boundary.count > 96
    assert boundary.mean_absolute < 0.002
