import numpy as np
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas, edge_table
from bodymeasure.scene import PathKind, body_scene, patch_scene


def test_paths_lie_on_the_surface_between_the_patch_corners(body: Atlas) -> None:
    paths = body_scene(straight_survey(body)).paths
    net = body.control_points
    np.testing.assert_allclose(paths.lines.points[::2, 0], net[:, 0, 0], atol=1e-12)
    np.testing.assert_allclose(paths.lines.points[::2, -1], net[:, 3, 3], atol=1e-12)
    np.testing.assert_allclose(paths.lines.points[1::2, 0], net[:, 3, 0], atol=1e-12)
    np.testing.assert_allclose(paths.lines.points[1::2, -1], net[:, 0, 3], atol=1e-12)
    np.testing.assert_array_equal(paths.patch, np.repeat(np.arange(len(body)), 2))


def test_each_seam_is_drawn_once(body: Atlas) -> None:
    scene = body_scene(straight_survey(body))
    assert len(scene.edges.points) == len(edge_table(body.index).sides)


def test_normals_are_perpendicular_to_a_plane(square: Atlas) -> None:
    surface = body_scene(straight_survey(square)).surface
    np.testing.assert_allclose(np.abs(surface.normals @ [0.0, 1.0, 0.0]), 1.0, atol=1e-12)


def test_a_collapsed_edge_still_has_a_normal() -> None:
    ticks = np.linspace(0.0, 1.0, 4)
    net = np.zeros((4, 4, 3))
    net[..., 0], net[..., 2] = ticks[:, None] * ticks, ticks  # v = 0 is a point
    surface = body_scene(straight_survey(Atlas.from_control_points(net, "m"))).surface
    np.testing.assert_allclose(np.linalg.norm(surface.normals, axis=-1), 1.0, atol=1e-12)


def test_kinds_tell_good_lengths_compared_ones_and_none_apart(square: Atlas) -> None:
    missing = np.array([[True, False]])
    paths = body_scene(straight_survey(square, difference=-2e-7, no_length=missing)).paths
    assert list(paths.kind) == [PathKind.NO_LENGTH, PathKind.COMPARED]
    np.testing.assert_array_equal(paths.value, [np.nan, 2e-7])
    unchecked = body_scene(straight_survey(square, check=False)).paths
    assert list(unchecked.kind) == [PathKind.NOT_COMPARED, PathKind.NOT_COMPARED]


def test_a_path_that_strays_far_from_its_patch_is_cut_off(square: Atlas) -> None:
    points = body_scene(straight_survey(square, bulge=1.0)).paths.lines.points
    inside = np.asarray(np.isfinite(points).all(axis=-1))
    assert inside[:, [0, -1]].all()
    assert not inside.all()
    assert points[inside][:, 0].max() <= 0.1 * 1.25 + 1e-12


def test_a_path_that_could_not_be_computed_is_drawn_straight(square: Atlas) -> None:
    missing = np.array([[True, True]])
    survey = straight_survey(square, no_length=missing)
    straight = body_scene(survey).paths.lines.points
    survey.diagonals.path = lambda t: np.full((1, 2, len(t), 2), np.nan)
    np.testing.assert_allclose(body_scene(survey).paths.lines.points, straight, atol=1e-15)


def test_a_patch_scene_fades_all_but_its_patch(body: Atlas) -> None:
    scene = patch_scene(straight_survey(body), 17)
    faded = scene.surface.faded[scene.surface.triangles].all(axis=1)
    np.testing.assert_array_equal(faded, scene.surface.patch != 17)
    assert len(scene.edges.points) == 4
    assert set(scene.paths.patch) == {17}
    np.testing.assert_allclose(scene.labels[1].position, body.control_points[17][3, 0])
    assert scene.labels[1].text == "(1, 0)"
