"""Sections by planes through poles: sides of patches that are collapsed to a point."""

import numpy as np
import pytest
from helpers.surfaces.quadrics import joined, sphere_nets, stretched
from helpers.surfaces.tubes import cone
from scipy.special import ellipe

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.section import Plane, plane_section

TRIAXIAL = (1.0, 0.7, 0.4)


def ellipsoid(axes: tuple[float, float, float]) -> Atlas:
    return joined(stretched(sphere_nets(), axes))


def perimeter(axes: tuple[float, float, float], plane: Plane) -> float:
    """The perimeter of the ellipse in which a plane cuts an ellipsoid about the origin.

    In coordinates in which the ellipsoid is the unit sphere, the section is a circle; the map back
    to space takes it to an ellipse whose half-axes are its singular values.
    """
    scale = np.array(axes)
    normal = scale * plane.normal
    away = plane.point @ plane.normal / np.linalg.norm(normal)
    frame = np.linalg.svd((normal / np.linalg.norm(normal))[None])[2][1:]
    long, short = np.linalg.svd(scale[:, None] * frame.T)[1] * np.sqrt(1.0 - away**2)
    return float(4.0 * long * ellipe(1.0 - (short / long) ** 2))


def upright(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle), 0.0])


@pytest.mark.parametrize("axes", [(1.0, 1.0, 1.0), TRIAXIAL])
@pytest.mark.parametrize("angle", [0.0, 0.3, 0.5 * np.pi, 0.75 * np.pi, 2.9])
def test_planes_through_both_poles(axes: tuple[float, float, float], angle: float) -> None:
    # At multiples of a quarter turn, the plane holds seams besides.
    plane = Plane(np.zeros(3), upright(angle))
    (loop,) = plane_section(ellipsoid(axes), plane).loops
    assert loop.closed
    assert abs(loop.length - perimeter(axes, plane)) <= loop.error_estimate + 1e-14
    assert loop.error_estimate <= 2e-10
    assert np.abs(plane.distances(loop.positions)).max() <= 2e-11


@pytest.mark.parametrize("axes", [(1.0, 1.0, 1.0), TRIAXIAL])
def test_tilted_planes_through_a_pole(
    axes: tuple[float, float, float], rng: np.random.Generator
) -> None:
    for sign in (1.0, -1.0):
        plane = Plane(np.array([0.0, 0.0, sign * axes[2]]), rng.normal(size=3))
        (loop,) = plane_section(ellipsoid(axes), plane).loops
        assert loop.closed
        assert abs(loop.length - perimeter(axes, plane)) <= loop.error_estimate + 1e-14
        # The loop leads through the pole itself.
        assert np.linalg.norm(loop.positions - plane.point, axis=1).min() <= 1e-12


@pytest.mark.parametrize("away", [1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4])
def test_planes_close_to_the_poles(away: float) -> None:
    plane = Plane(away * upright(0.3), upright(0.3))
    (loop,) = plane_section(ellipsoid(TRIAXIAL), plane).loops
    assert loop.closed
    assert abs(loop.length - perimeter(TRIAXIAL, plane)) <= loop.error_estimate + 1e-14
    assert loop.error_estimate <= 2e-10


@pytest.mark.parametrize("height", [0.0, 1.0, -2.0])
def test_a_plane_through_the_tip_of_a_cone_cuts_it_in_two_rulings(height: float) -> None:
    # The atlas's own seams are rulings, which the plane through them has to be turned off.
    atlas = cone(height)
    (loop,) = plane_section(
        atlas, Plane(np.array([0.0, 0.0, height]), np.array([0.0, 1.0, 0.0]))
    ).loops
    assert not loop.closed
    assert loop.length == pytest.approx(2.0 * np.hypot(1.0, height), abs=loop.error_estimate)


def test_a_plane_that_meets_a_cone_in_its_tip_alone_has_no_curve() -> None:
    assert not plane_section(
        cone(1.0), Plane(np.array([0.0, 0.0, 1.0]), np.array([0.1, 0.2, 1.0]))
    ).loops
