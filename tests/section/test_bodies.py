"""Sections of the mannequins, compared with those of tessellations."""

import numpy as np
import pytest
from helpers.oracles.mesh_sections import richardson_length
from scipy.spatial import ConvexHull

from bodymeasure.errors import InputError
from bodymeasure.samples import load_sample
from bodymeasure.section import Plane, convex_hull, plane_section

PLANES = 100


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_full_bust", "female_old", "male_average"])
def test_random_planes(name: str, rng: np.random.Generator) -> None:
    atlas = load_sample(name)
    refused = 0
    errors = []
    for number in range(PLANES):
        point = atlas.points[rng.integers(len(atlas.points))]
        normal = rng.normal(size=3) if number % 2 else atlas.axes.up_vector
        plane = Plane(point, normal)
        try:
            loops = plane_section(atlas, plane).loops
        except InputError:
            refused += 1
            continue
        length = sum(loop.length for loop in loops)
        known, move = richardson_length(atlas, plane)
        # The mesh is uncertain itself where the plane runs almost along the surface.
        assert abs(length - known) <= 1e-6 * known + move
        errors.append(abs(length - known) / known)
        for loop in loops:
            assert loop.error_estimate <= 1e-8 * length
            if loop.closed:
                hull = convex_hull(loop)
                assert hull.length <= loop.length
    assert refused <= 1
    assert np.mean(np.array(errors) <= 1e-6) >= 0.99
    assert np.median(errors) <= 1e-7


def test_both_sides_of_a_symmetric_body_agree() -> None:
    atlas = load_sample("female_average")
    left, right = (
        atlas.position(atlas.landmarks[f"patella point {side}"]) for side in ("left", "right")
    )
    tilt = np.array([0.2, 0.1, 1.0])
    mirrored = tilt * (-1.0, 1.0, 1.0)
    first = plane_section(atlas, Plane(left, tilt)).nearest(left)
    second = plane_section(atlas, Plane(right, mirrored)).nearest(right)
    assert first.length == pytest.approx(second.length, rel=1e-12)
    assert convex_hull(first).length == pytest.approx(convex_hull(second).length, rel=1e-12)
    for region, length in first.length_by_region.items():
        other = second.length_by_region[region.replace("left", "right")]
        assert length == pytest.approx(other, rel=1e-11)


def test_the_center_plane_lies_in_the_seams() -> None:
    atlas = load_sample("male_average")
    (loop,) = plane_section(atlas, Plane(np.zeros(3), atlas.axes.left_vector)).loops
    assert not loop.closed
    assert loop.error_estimate < 1e-9
    known, move = richardson_length(
        atlas, Plane(1e-7 * atlas.axes.left_vector, atlas.axes.left_vector)
    )
    assert loop.length == pytest.approx(known, abs=1e-6 + move)


@pytest.mark.parametrize(("name", "corner"), [("female_average", 182), ("male_average", 1229)])
def test_hollows_beside_corners_of_patches(name: str, corner: int) -> None:
    atlas = load_sample(name)
    corners = atlas.control_points[:, ::3, ::3].reshape(-1, 3)
    plane = Plane(corners[corner], atlas.axes.up_vector)
    loops = [loop for loop in plane_section(atlas, plane).loops if loop.closed]
    # The plane is moved off the corner, and cuts pieces from the patches there that are tiny.
    assert min(loop.piece_length.min() for loop in loops) < 1e-9
    for loop in loops:
        coarse, fine = (
            ConvexHull(
                loop.positions_at(np.arange(count * loop.count) / count) @ plane.frame().T
            ).area
            for count in (500, 1000)
        )
        # Polygons of samples are too short by the square of their steps.
        known = fine + (fine - coarse) / 3.0
        assert convex_hull(loop).length == pytest.approx(known, abs=1e-11)
