"""Planes that cut, and the roots that a section is made of."""

import math

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.atlas import weld
from bodymeasure.bezier import bernstein
from bodymeasure.errors import InputError
from bodymeasure.section import Plane, plane_section


@pytest.mark.parametrize(
    ("point", "normal", "message"),
    [
        ((0, 0, 0), (0, 0, 0), "normal is zero"),
        ((0, 0), (0, 0, 1), "point is .*expected three finite numbers"),
        ((0, 0, 0), (0, 0, math.nan), "normal is .*expected three finite numbers"),
        ((0, 0, 0), "up", "normal is 'up'; expected three numbers"),
    ],
)
def test_planes_are_checked(point: object, normal: object, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Plane(point, normal)  # type: ignore[arg-type]


def test_roots_of_cubics_keep_their_number() -> None:
    from bodymeasure.section.roots import roots_of_polynomials

    wanted = np.array([[0.2, 0.5, 0.9], [0.1, 0.1 + 1e-7, 0.7]])
    t = np.linspace(0.0, 1.0, 4)
    basis = bernstein(3, t)[:, 0]
    values = np.prod(t[:, None] - wanted[:, None], axis=-1)
    found = roots_of_polynomials(np.linalg.solve(basis, values.T).T)
    np.testing.assert_allclose(found[0], wanted[0], atol=1e-14)
    np.testing.assert_allclose(found[1], wanted[1], atol=1e-9)
    assert np.isnan(roots_of_polynomials(np.ones((1, 4)))).all()


def box() -> bm.Atlas:
    """The box from (0, 0, 0) to (1, 2, 3)."""
    along = np.linspace(0.0, 1.0, 4)
    u, v = np.meshgrid(along, along, indexing="ij")
    nets = []
    for axis in range(3):
        for value in (0.0, 1.0):
            net = np.empty((4, 4, 3))
            net[..., axis] = value
            first, second = (u, v) if value == 1.0 else (v, u)
            net[..., (axis + 1) % 3], net[..., (axis + 2) % 3] = first, second
            nets.append(net * (1.0, 2.0, 3.0))
    points, index = weld(np.array(nets))
    return bm.Atlas(points, index, bm.Unit.CM)


@pytest.mark.parametrize("off", [0.0, 1e-13, -1e-12])
@pytest.mark.parametrize("turn", [0.1, 0.7, 1.4])
def test_a_plane_that_touches_a_ridge_misses(turn: float, off: float) -> None:
    normal = (math.cos(turn), math.sin(turn), 0.0)
    # Along the edge at x = y = 0, and in the corner at its end.
    for tilt in (0.0, 0.3):
        point = np.array([-off * normal[0], -off * normal[1], 0.0])
        touching = Plane(point, np.array([*normal[:2], tilt]))
        assert plane_section(box(), touching).loops == ()


def test_beside_the_ridge_it_cuts() -> None:
    normal = (math.cos(0.7), math.sin(0.7), 0.0)
    for far in (1e-3, 1e-6):
        (loop,) = plane_section(box(), Plane(np.array([0.0, far, 0.0]), np.array(normal))).loops
        width = far * math.sin(0.7) * (1.0 / math.tan(0.7) + math.tan(0.7))
        assert loop.length == pytest.approx(2.0 * (3.0 + width), rel=1e-9)
