import numpy as np

import bodymeasure as bm
from bodymeasure.fit.model import (
    atlas_of_vertices,
    body_model,
    coefficients_of,
    control_points_of,
    limit_matrix,
    shaped,
)
from bodymeasure.fit.model.space import DATA
from bodymeasure.subdivision import QuadMesh, limit_positions


def test_components_move_the_surface_by_their_sigma() -> None:
    model = body_model()
    squares = np.einsum("knd,n->k", model.components**2, model.vertex_weight)
    # The components are rounded to 5 micrometers, and the last moves the surface by 0.13 mm.
    np.testing.assert_allclose(np.sqrt(squares), model.sigma, rtol=5e-3)


def test_coefficients_come_back_from_the_vertices(rng: np.random.Generator) -> None:
    coefficients = rng.standard_normal(120)
    np.testing.assert_allclose(coefficients_of(shaped(coefficients)), coefficients, atol=1e-9)


def test_limits_are_those_of_the_subdivided_surface(rng: np.random.Generator) -> None:
    vertices = shaped(rng.standard_normal(60))
    expected = limit_positions(QuadMesh(vertices, body_model().quads))
    np.testing.assert_allclose(limit_matrix() @ vertices, expected, atol=1e-14)


def test_the_map_follows_rigid_motions_and_scaling(rng: np.random.Generator) -> None:
    vertices = shaped(rng.standard_normal(60))
    turn = np.linalg.qr(rng.standard_normal((3, 3)))[0]
    shift = rng.standard_normal(3)
    moved = control_points_of(1.7 * vertices @ turn.T + shift)
    np.testing.assert_allclose(moved, 1.7 * control_points_of(vertices) @ turn.T + shift, atol=2e-6)


def test_the_atlas_lies_on_the_limit_surface_and_has_the_samples_layout() -> None:
    atlas = atlas_of_vertices(shaped(np.array([0.5, -1.0, 1.0])), name="someone")
    sample = bm.load_sample("male_average")
    assert atlas.patch_names == sample.patch_names
    assert atlas.regions == sample.regions
    assert (atlas.unit, atlas.axes, atlas.name) == (bm.Unit.M, sample.axes, "someone")
    assert set(atlas.landmarks) == set(sample.landmarks)
    assert not [each for each in bm.check_atlas(atlas) if each.severity is bm.Severity.ERROR]


def test_carried_landmarks_lie_at_the_limits_of_their_vertices(rng: np.random.Generator) -> None:
    vertices = shaped(0.8 * rng.standard_normal(60))
    atlas = atlas_of_vertices(vertices)
    with np.load(DATA / "atlas_map.npz") as data:
        numbers = dict(zip(data["landmark_names"].tolist(), data["landmark_vertex"], strict=True))
    limits = limit_matrix() @ vertices
    distance = [
        np.linalg.norm(atlas.position(place) - limits[numbers[name]])
        for name, place in atlas.landmarks.items()
    ]
    assert np.sqrt(np.mean(np.square(distance))) < 6e-4
    assert max(distance) < 2e-3
