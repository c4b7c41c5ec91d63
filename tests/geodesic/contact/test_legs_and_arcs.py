"""The legs and arcs of paths along edges of a patch, and how they are joined."""

import numpy as np
import pytest
from helpers.surfaces.height_fields import bent_plane, heights
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.geodesic.contact.edge_arc import edge_arc
from bodymeasure.geodesic.contact.legs import Contact, read_legs
from bodymeasure.geodesic.contact.tangency import SAFETY, tangency_errors
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces


def test_the_pattern_of_a_polygon() -> None:
    inside = [0.3, 0.5]
    polygon = np.array(
        [[0, 0], [0, 0.2], [0, 0.4], inside, [0.6, 1], [0.8, 1], [0.9, 0.9], [1, 0.5]]
    )
    legs = read_legs(polygon)
    assert [leg.contact.name if leg.contact else "free" for leg in legs] == [
        "u = 0",
        "free",
        "v = 1",
        "free",
    ]
    assert [(leg.first, leg.last) for leg in legs] == [(0, 2), (2, 4), (4, 5), (5, 7)]
    # A free leg slides where it meets an arc, and is fixed at the ends of the path.
    slides = [tuple(s.name if s else None for s in leg.ends) for leg in legs if not leg.contact]
    assert slides == [("u = 0", "v = 1"), ("v = 1", None)]


@pytest.mark.parametrize("bulge", [2.4, -2.4])
def test_an_edge_presses_where_it_is_in_the_way(bulge: float) -> None:
    # x = bulge v (1 - v) on u = 0: an arc along it is shortest if the patch lies outside its bend.
    net = bent_plane()
    net[:, :, 0] += (bulge / 2.4 - 1.0) * (net[:, :, 0] - np.linspace(0, 1, 4)[:, None])
    surface = BezierSurfaces(net[None])
    arc = edge_arc(surface, Contact(0, 0.0), np.array([0.0, 0.2]), np.array([0.0, 0.9]))
    assert arc.is_pressed == (bulge > 0.0)
    t = np.linspace(0.2, 0.9, 20001)
    along = np.hypot(np.diff(bulge * t * (1.0 - t)), np.diff(t)).sum()
    assert arc.solved.length.raw[0] == pytest.approx(along, rel=1e-8)


def test_a_straight_edge_presses_nothing_and_is_not_refused(rng: np.random.Generator) -> None:
    surface = BezierSurfaces(heights(np.zeros((4, 4)))[None])
    for axis, value in ((0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)):
        begin, end = rng.random((2, 2))
        begin[axis] = end[axis] = value
        arc = edge_arc(surface, Contact(axis, value), begin, end)
        assert arc.is_pressed
        assert arc.solved.length.raw[0] == pytest.approx(np.abs(end - begin).sum(), rel=1e-14)


def test_legs_that_meet_at_a_corner_are_fixed_there() -> None:
    polygon = np.array([[0.5, 0.5], [0.2, 0.8], [0.0, 1.0], [0.3, 0.9], [0.6, 0.6]])
    legs = read_legs(polygon)
    assert [(leg.first, leg.last, leg.ends) for leg in legs if not leg.contact] == [
        (0, 2, (None, None)),
        (2, 4, (None, None)),
    ]
    round_it = np.array([[0.0, 0.5], [0.0, 0.8], [0.0, 1.0], [0.3, 1.0], [0.6, 0.6]])
    names = [leg.contact.name if leg.contact else "free" for leg in read_legs(round_it)]
    assert names == ["u = 0", "v = 1", "free"]


@pytest.mark.parametrize("off", [-0.03, -0.01, 0.01, 0.03])
def test_a_joint_in_the_wrong_place_is_told(off: float) -> None:
    # In the plane: along the edge x = 2.4 y (1 - y) to a joint beside the right one, then on a
    # curve that is tangential there, as a polynomial of low degree would be, to (0.3, 1).
    target, corner = np.array([0.3, 1.0]), np.zeros(2)

    def on_edge(t: float) -> Array:
        return np.array([2.4 * t * (1.0 - t), t])

    def whole(t: float) -> float:
        arc = edge_arc(surface, Contact(0, 0.0), corner, np.array([0.0, t]))
        chord = np.linalg.norm(target - on_edge(t))
        return float(arc.solved.length.raw[0] + chord)

    surface = BezierSurfaces(bent_plane()[None])
    right = 1.0 - np.sqrt(0.3 / 2.4)  # where the tangent of the edge meets (0.3, 1)
    joint = right + off
    begin, tangent = on_edge(joint), np.array([2.4 * (1.0 - 2.0 * joint), 1.0])
    space = polynomial_space(24)
    t = space.nodes[:, None]
    control = begin + 0.3 * tangent / np.linalg.norm(tangent)
    x, y = ((1 - t) ** 2 * begin + 2 * t * (1 - t) * control + t**2 * target).T
    edge = 2.4 * y * (1.0 - y)
    values = np.stack([(x - edge) / (1.0 - edge), y])
    told = tangency_errors(surface, space, values[None], [(Contact(0, 0.0), None)]) / SAFETY
    assert told[0] == pytest.approx(abs(whole(joint) - whole(right)), rel=0.2)


def test_the_length_of_an_edge_whose_speed_almost_vanishes() -> None:
    # A cylinder over a cubic with a cusp beside it. The length is that of adaptive quadrature.
    curve = np.array(
        [
            (-0.16598536396439068, 0.5173666233171519),
            (1.6010090117576607, 0.3520136407218413),
            (0.134871338631837, -0.06284195169858134),
            (-0.7832046627088782, 2.0297970631842297),
        ]
    )
    net = np.zeros((4, 2, 3))
    net[:, :, :2] = curve[:, None]
    net[:, 1, 2] = 1.0
    solution = bm.solve_geodesic(net, [(0.0, 0.0), (0.0, 1.0)], [(1.0, 0.0), (1.0, 1.0)])

    def speed(t: float) -> float:
        basis = np.array([(1.0 - t) ** 2, 2.0 * t * (1.0 - t), t**2])
        return float(np.linalg.norm(3.0 * basis @ np.diff(curve, axis=0)))

    slowest = minimize_scalar(speed, bounds=(0.0, 1.0), options={"xatol": 1e-12}).x
    known = quad(speed, 0.0, 1.0, points=[slowest], epsabs=1e-13, epsrel=1e-13, limit=200)[0]
    assert known == pytest.approx(3.0983057781555, abs=1e-12)
    assert (solution.error_estimate <= 1e-13).all()
    np.testing.assert_allclose(solution.length, known, rtol=1e-13)
