"""The quad meshes that come with the samples belong to them."""

import re

import numpy as np
import pytest
from helpers.bodies import BODIES, ONE_QUICKLY

from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.errors import InputError
from bodymeasure.paper.surface.source_mesh import load_source_mesh
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import limit_positions, quads_within


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_the_atlas_lies_on_the_meshs_limit_surface_as_its_provenance_says(name: str) -> None:
    mesh, covered = load_source_mesh(name)
    atlas = load_sample(name)
    vertices = np.unique(mesh.quads[:covered])
    _, distance = closest_points(atlas, limit_positions(mesh)[vertices])
    millimeters = 1e3 * distance
    stated = re.findall(r"([\d.]+) mm", atlas.provenance["fit"])
    measured = (np.sqrt(np.mean(millimeters**2)), np.quantile(millimeters, 0.99), millimeters.max())
    assert [f"{value:.2f}" for value in measured] == stated
    assert f"the {len(vertices)} control mesh vertices" in atlas.provenance["fit"]


def test_the_meshes_share_their_quads_and_are_wide_enough_for_the_limit_surface() -> None:
    mesh, covered = load_source_mesh("female_average")
    inner = np.unique(mesh.quads[:covered])
    on_boundary = np.unique(mesh.edges.ends[mesh.edges.boundary])
    # At least two rings of quads lie between the covered part and the mesh's boundary.
    near = quads_within(mesh, inner, 2)
    assert not np.isin(on_boundary, mesh.quads[near]).any()
    # There is one closed curve on each of five openings.
    assert len(on_boundary) == mesh.edges.boundary.sum()
    for name in BODIES[1:]:
        other, count = load_source_mesh(name)
        np.testing.assert_array_equal(other.quads, mesh.quads)
        assert count == covered
        assert (other.vertices != mesh.vertices).any()


def test_coordinates_are_whole_micrometers_in_meters() -> None:
    vertices = load_source_mesh("female_heavy")[0].vertices
    np.testing.assert_array_equal(vertices, np.round(vertices, 6))
    assert 1.2 < np.ptp(vertices[:, 2]) < 1.7


def test_samples_without_a_mesh_are_refused_by_name() -> None:
    with pytest.raises(InputError, match=r"'enneper' was not fitted to a mesh.* female_average, "):
        load_source_mesh("enneper")
    with pytest.raises(InputError, match="no sample is named 'femal'"):
        load_source_mesh("femal")
