"""Planes that cut, and the roots that a section is made of."""

import math

import numpy as np
import pytest

from bodymeasure.bezier import bernstein
from bodymeasure.errors import InputError
from bodymeasure.section import Plane


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
