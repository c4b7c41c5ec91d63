"""Shortest paths made of elements, on patches that one polynomial a leg does not serve."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.surfaces.height_fields import bent_plane, heights

import bodymeasure as bm
from bodymeasure._typing import Array, Bools
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.contact.legs import Pole
from bodymeasure.geodesic.contact.solve import solve_contact_paths
from bodymeasure.geodesic.elements import solve
from bodymeasure.geodesic.elements.measure import ElementLength, measure_elements
from bodymeasure.geodesic.elements.path import ElementPath
from bodymeasure.geodesic.elements.rival import NO_RIVAL, Rival
from bodymeasure.geodesic.elements.solve import solve_elements
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import Surface

HARD: list[dict[str, Any]] = json.loads(
    (Path(__file__).parents[2] / "data" / "hard_patches.json").read_text()
)
ROUNDING = 4e-15
LINE = np.linspace(0.0, 1.0, 33)[:, None]


FAST = ("cyl", "rat", "thin")


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(
            case, id=case["kind"], marks=[pytest.mark.slow] if case["kind"] not in FAST else []
        )
        for case in HARD
    ],
)
def test_lengths_are_those_of_another_solver(case: dict[str, Any]) -> None:
    points, length = np.array(case["points"]), case["length"]
    solution = bm.solve_geodesic(points, case["start"], case["end"])
    allowed = solution.error_estimate + case["doubt"] + ROUNDING * length
    assert abs(solution.length - length) <= allowed
    assert solution.error_estimate <= 1e-9 * length


def uneven_square(at: tuple[float, ...]) -> Array:
    net = np.zeros((4, 4, 3))
    net[:, :, 0] = np.array(at)[:, None]
    net[:, :, 1] = np.linspace(0.0, 1.0, 4)
    return net


@pytest.mark.parametrize(
    "at", [(0.0, 0.001, 0.02, 1.0), pytest.param((0.0, 1e-4, 1.0, 1.0), marks=pytest.mark.slow)]
)
def test_an_unevenly_parametrized_square(at: tuple[float, ...]) -> None:
    # The patch is a flat unit square, so that all distances are those of the plane.
    net = uneven_square(at)
    ends = np.array([[(0.0, 0.0), (1.0, 1.0)], [(0.001, 0.9), (0.7, 0.2)]])
    solution = bm.solve_geodesic(net, ends[:, 0], ends[:, 1])
    chord = np.linalg.norm(evaluate(net, ends[:, 1]) - evaluate(net, ends[:, 0]), axis=1)
    error = np.abs(solution.length - chord)
    assert (error <= solution.error_estimate).all()
    assert (solution.error_estimate <= 1e-9).all()


def test_a_cylinder_whose_generator_dips_in_speed() -> None:
    curve = np.array(
        [
            (-0.5118795445527522, 0.33452648360440757),
            (-2.1266836963811473, -0.6468087625992227),
            (1.694093202177908, 0.21132613280362944),
            (-0.24039851728557995, 0.372928487050425),
        ]
    )
    net = np.zeros((4, 4, 3))
    net[:, :, :2] = curve[:, None]
    net[:, :, 2] = 5.019702309420379 * np.linspace(0.0, 1.0, 4)
    solution = bm.solve_geodesic(net, (0.7412243569425271, 0.0), (0.0, 0.47971128509864014))
    # Unrolled: the length of the curve by quadrature of its speed, and the height.
    nodes, weights = np.polynomial.legendre.leggauss(400)
    t = 0.7412243569425271 * (nodes + 1.0) / 2.0
    basis = 3.0 * np.stack([(1 - t) ** 2, 2 * t * (1 - t), t**2], axis=1)
    speed = np.linalg.norm(basis @ np.diff(curve, axis=0), axis=1)
    along = 0.7412243569425271 / 2.0 * (weights @ speed)
    known = np.hypot(along, 0.47971128509864014 * 5.019702309420379)
    assert known == pytest.approx(3.055074190389, abs=1e-12)
    assert abs(solution.length - known) <= solution.error_estimate
    assert solution.error_estimate <= 1e-9


@pytest.mark.parametrize("end", [(0.0, 1.0), (0.3, 1.0)])
def test_arcs_along_an_edge_are_those_of_legs(end: tuple[float, float]) -> None:
    surface = BezierSurfaces(bent_plane()[None])
    polygon = descend(surface, (LINE * np.array(end))[None])[0]
    legs = solve_contact_paths(surface, [polygon], [(None, None)], 1e-10)[0]
    found = solve_elements(surface, polygon, (None, None), tolerance=1e-10)
    assert legs is not None
    assert found.path is not None
    length = found.path.length
    error = legs.length.error + length.error
    assert np.abs(length.corrected - legs.length.corrected)[0] <= error[0] <= 1e-9
    (known,), (contact,) = legs.contacts, found.path.contacts
    assert contact.edge == known.edge
    assert (contact.start, contact.end) == pytest.approx((known.start, known.end), abs=1e-3)
    # The path is one function of the part of its length.
    points = found.path.space.matrices(np.linspace(0.0, 1.0, 9))[0] @ found.path.values.T
    places = evaluate(bent_plane(), points)
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert steps.sum() == pytest.approx(length.corrected[0], rel=2e-2)
    assert np.ptp(steps) < 0.05 * steps.mean()


def test_a_path_leaves_a_pole_in_any_direction() -> None:
    # A flat triangle, collapsed at u = 0: from the pole to (1, 0.5) it is straight.
    net = np.zeros((4, 4, 3))
    u, v = np.meshgrid(np.linspace(0, 1, 4), np.linspace(0, 1, 4), indexing="ij")
    net[:, :, 0], net[:, :, 1] = u, u * v
    surface = BezierSurfaces(net[None])
    polygon = np.array([0.0, 0.2]) + LINE * np.array([1.0, 0.3])
    found = solve_elements(surface, polygon, (Pole(0, 0.0), None), tolerance=1e-10)
    assert found.path is not None
    known = np.hypot(1.0, 0.5)
    assert abs(found.path.length.corrected[0] - known) <= found.path.length.error[0]
    assert found.path.values[1, 0] == pytest.approx(0.5, abs=1e-6)


def test_a_budget_and_a_shorter_path_end_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    case = HARD[0]
    surface = BezierSurfaces(np.array(case["points"])[None])
    start, end = np.array(case["start"]), np.array(case["end"])
    polygon = start + LINE * (end - start)
    rival = NO_RIVAL._replace(length=0.5 * case["length"])
    longer = solve_elements(surface, polygon, (None, None), tolerance=1e-10, rival=rival)
    assert longer.path is None
    assert longer.least > 0.5 * case["length"]
    monkeypatch.setattr(solve, "MOST_WORK", 100)
    assert solve_elements(surface, polygon, (None, None), tolerance=1e-10).path is None


def test_a_path_that_is_known_is_not_solved_again(monkeypatch: pytest.MonkeyPatch) -> None:
    # A flat unit square: all paths between two points lead to the chord.
    surface = BezierSurfaces(uneven_square((0.0, 0.001, 0.02, 1.0))[None])
    end = np.array([0.7, 0.9])
    start, chord = surface.jet(np.array([[(0.0, 0.0), end]]), 0)[0, :, 0].T
    chord = chord - start
    length = float(np.linalg.norm(chord))
    detour = np.clip(LINE * end + 0.1 * np.sin(np.pi * LINE) * np.array([-1.0, 1.0]), 0.0, 1.0)
    calls: list[int] = []

    def counted(surface: Surface, path: ElementPath, held: Bools) -> ElementLength:
        calls.append(len(path.widths))
        return measure_elements(surface, path, held)

    monkeypatch.setattr(solve, "measure_elements", counted)
    rival = Rival(length * (1.0 + 1e-8), start + np.linspace(0.0, 1.0, 9)[:, None] * chord)
    known = solve_elements(surface, detour, (None, None), tolerance=1e-10, rival=rival)
    first = len(calls)
    assert (known.path, known.least) == (None, rival.length)
    # Where the other path of this length is elsewhere, or no minimum, this one is solved.
    for positions in (rival.positions + 0.1, np.full((9, 3), np.nan)):
        calls.clear()
        elsewhere = rival._replace(positions=positions)
        found = solve_elements(surface, detour, (None, None), tolerance=1e-10, rival=elsewhere)
        assert found.path is not None
        assert abs(found.path.length.corrected[0] - length) <= found.path.length.error[0]
        assert len(calls) > first


@pytest.mark.slow
def test_a_ridge_beside_the_path_has_a_minimum_to_either_side() -> None:
    z = np.zeros((4, 4))
    z[1:3, 1:3] = 3.0
    solution = bm.solve_geodesic(heights(z, 0.3), (0.0, 0.0), (1.0, 1.0))
    mirrored = bm.solve_geodesic(heights(z.T, 0.3), (1.0, 1.0), (0.0, 0.0))
    error = solution.error_estimate + mirrored.error_estimate
    assert abs(solution.length - mirrored.length) <= error
