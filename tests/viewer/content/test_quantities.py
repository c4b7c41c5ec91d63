"""Colors show the surface's own curvatures and angles, and how far bodies are apart."""

from dataclasses import replace

import numpy as np
import pytest
import scipy
from bodymeasure.viewer.content.answers import answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.quantities import curvatures, distances, seam_angles
from bodymeasure.viewer.content.requests import ShowQuantity
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from helpers.surfaces.quadrics import joined, line, revolved, sphere_nets, stretched, torus_nets

from bodymeasure import Atlas, Unit, load_sample
from bodymeasure.errors import InputError


def shown(atlas: Atlas) -> ShownBody:
    return ShownBody("0", atlas, "A solid")


@pytest.mark.parametrize("unit", ["m", "mm"])
def test_a_sphere_is_curved_alike_everywhere(unit: str) -> None:
    atlas = replace(joined(stretched(sphere_nets(), (2.0, 2.0, 2.0))), unit=Unit(unit))
    radius = 2.0 * atlas.unit.meters
    gaussian, mean = curvatures(shown(atlas))
    # Beside the poles, second derivatives are differences of nearly equal numbers.
    np.testing.assert_allclose(gaussian, 1.0 / radius**2, rtol=1e-5)
    np.testing.assert_allclose(mean, 1.0 / radius, rtol=1e-5)


def test_a_torus_is_a_saddle_inside_and_a_dome_outside() -> None:
    large, small = 3.0, 1.0
    body = shown(joined(torus_nets(large, small)))
    gaussian, mean = curvatures(body)
    ticks = np.linspace(0.0, 1.0, body.segments + 1)
    grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)
    spread = np.broadcast_to(grid, (len(body.atlas), *grid.shape))
    positions, _ = body.surface(np.arange(len(body.atlas)), spread)
    # The page's second axis is up, which is the torus's own.
    across = np.hypot(positions[..., 0], positions[..., 2])
    cosine = (across - large) / small
    np.testing.assert_allclose(
        gaussian.reshape(cosine.shape), cosine / (small * across), rtol=1e-9, atol=1e-9
    )
    expected = (large + 2.0 * small * cosine) / (2.0 * small * across)
    np.testing.assert_allclose(mean.reshape(cosine.shape), expected, rtol=1e-9)


def test_a_cylinder_bends_one_way() -> None:
    nets = [revolved(line((0.5, 0.0), (0.5, 2.0)), number) for number in range(4)]
    gaussian, mean = curvatures(shown(joined(np.array(nets))))
    np.testing.assert_allclose(gaussian, 0.0, atol=1e-12)
    np.testing.assert_allclose(mean, 1.0, rtol=1e-9)


def test_seams_of_a_smooth_surface_have_no_angle() -> None:
    angles = seam_angles(shown(joined(torus_nets(3.0, 1.0))))
    assert angles.shape == (32, 17)
    np.testing.assert_allclose(angles, 0.0, atol=1e-6)


@pytest.mark.parametrize("turned", [False, True])
def test_the_angle_at_a_fold_is_that_of_the_sheets(turned: bool) -> None:
    fold = np.radians(30.0)
    grid = np.stack(np.meshgrid(range(4), range(4), indexing="ij"), axis=-1) / 3.0
    first = np.concatenate([grid, np.zeros((4, 4, 1))], axis=-1)
    second = first.copy()
    second[..., 0] = 1.0 + grid[..., 0] * np.cos(fold)
    second[..., 2] = grid[..., 0] * np.sin(fold)
    # The second sheet runs against the first along their seam, and faces the same way.
    second = second[::-1, ::-1] if turned else second
    nets = np.stack([first, second])
    points, index = np.unique(nets.reshape(-1, 3), axis=0, return_inverse=True)
    atlas = Atlas(points, index.reshape(2, 4, 4), Unit.M)
    angles = seam_angles(shown(atlas))
    known = np.isfinite(angles)
    assert known.sum(axis=1).tolist().count(17) == 1
    np.testing.assert_allclose(angles[known], 30.0, rtol=1e-9)


def test_a_body_moved_and_turned_is_at_no_distance(female: ShownBody) -> None:
    turn = scipy.spatial.transform.Rotation.from_rotvec((0.3, -0.2, 1.0)).as_matrix()
    atlas = female.atlas
    moved = replace(atlas, points=atlas.points @ turn.T + (1.0, 2.0, 3.0))
    np.testing.assert_allclose(distances(female, replace(female, atlas=moved)), 0.0, atol=1e-12)


def test_the_distance_of_a_larger_body_is_that_of_its_places(female: ShownBody) -> None:
    larger = replace(female, atlas=replace(female.atlas, points=1.1 * female.atlas.points))
    found = distances(female, larger)
    ticks = np.linspace(0.0, 1.0, female.segments + 1)
    grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)
    spread = np.broadcast_to(grid, (len(female.atlas), *grid.shape))
    positions, _ = female.surface(np.arange(len(female.atlas)), spread)
    away = positions - positions.reshape(-1, 3).mean(axis=0)
    expected = 0.1 * np.linalg.norm(away, axis=-1).reshape(found.shape)
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_bodies_with_other_patches_are_not_compared(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="have different patches"):
        answer(bodies, ShowQuantity(key="distance", other="2"))
    with pytest.raises(InputError, match="no body is open as ''"):
        answer(bodies, ShowQuantity(key="distance"))


@pytest.mark.parametrize(
    ("key", "scale", "per"),
    [
        ("gaussian", "diverging", "vertex"),
        ("mean", "diverging", "vertex"),
        ("seam_angle", "sequential", "seam"),
        ("distance", "sequential", "vertex"),
    ],
)
def test_a_scale_leaves_out_the_few_largest_values(
    bodies: Bodies, key: str, scale: str, per: str
) -> None:
    message = answer(bodies, ShowQuantity(key=key, other="1"))
    assert isinstance(message, bytes)
    header, arrays = unpacked(message)
    assert (header["scale"], header["per"], header["key"]) == (scale, per, key)
    low, high = header["low"], header["high"]
    assert low == (-high if scale == "diverging" else 0.0)
    values = arrays["values"][np.isfinite(arrays["values"])]
    beyond = (np.abs(values) > high).mean()
    assert 0.015 < beyond < 0.025
    assert header["words"].endswith("2 % of the values are beyond.")


def test_the_bust_of_a_body_is_a_dome() -> None:
    body = shown(load_sample("female_average"))
    gaussian, mean = curvatures(body)
    bust = body.atlas.landmarks["bust point left"]
    row = round(bust.u * body.segments), round(bust.v * body.segments)
    assert gaussian[(bust.patch, *row)] > 0.0
    assert mean[(bust.patch, *row)] > 0.0
