import math

import numpy as np
import pytest
from helpers.speed import quick
from helpers.surfaces.cut_atlases import cut
from helpers.surfaces.extruded_surfaces import CUBIC, HILL, RIDGE, ROOF, at, parabola_arc, row_of
from helpers.surfaces.quadrics import sphere_nets
from helpers.surfaces.surfaces import bicubic
from scipy.integrate import quad

import bodymeasure as bm
from bodymeasure.atlas import weld
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.bezier import elevate, project
from bodymeasure.taut import TautStatus

# The distance along y from start to end.
WAYS = pytest.mark.parametrize("along", quick([0.3, 0.0, 2.2]))
# Estimates hold down to this: below it, rounding and the steps of the takeoffs dominate.
SMALL = 2e-6


def drawn(
    atlas: bm.Atlas, start: tuple[float, float], end: tuple[float, float], outside: str
) -> bm.TautTape:
    tape = bm.taut_tape(
        atlas,
        at(atlas, *start),
        at(atlas, *end),
        outside="along normals" if outside == "above" else "against normals",
    )
    assert tape.status is TautStatus.CONVERGED
    assert tape.chord <= tape.length <= tape.contact.length
    assert tape.error_estimate <= SMALL * tape.length
    return tape


@WAYS
def test_over_a_ridge_the_taut_tape_is_the_geodesic(along: float) -> None:
    ridge = row_of(RIDGE)
    tape = drawn(ridge, (-0.8, 0.4), (0.6, 0.4 + along), "above")
    exact = math.hypot(parabola_arc(0.8) + parabola_arc(0.6), along)
    assert tape.length == pytest.approx(exact, rel=1e-8)
    assert tape.gap <= tape.error_estimate
    assert tape.touching.all()


@WAYS
def test_across_a_valley_the_taut_tape_is_the_chord(along: float) -> None:
    valley = row_of(RIDGE)
    tape = drawn(valley, (-0.8, 0.4), (0.6, 0.4 + along), "below")
    assert tape.length == pytest.approx(tape.chord, rel=1e-12)
    assert not tape.touching[1:-1].any()
    assert (tape.normals[1:-1] == 0.0).all()


@WAYS
@pytest.mark.parametrize("cuts", quick([(0.3, 0.55), ()]), ids=["cut", "whole"])
def test_from_a_hollow_onto_a_ridge_line_and_arc_meet_tangentially(
    along: float, cuts: tuple[float, ...]
) -> None:
    # The line from x = -a touches -x^3 at a / 2.
    a, b = 0.9, 0.8
    whole = row_of(CUBIC)
    atlas = cut(CUBIC, cuts, (0.4,) if cuts else (), turn=False)
    ends = [at(whole, -a, 0.2), at(whole, b, 0.2 + along)]
    moved = [closest_points(atlas, [whole.position(end)])[0][0] for end in ends]
    tape = bm.taut_tape(atlas, moved[0], moved[1], outside="along normals")
    line = math.hypot(1.5 * a, (a / 2) ** 3 + a**3)
    arc, _ = quad(lambda x: math.hypot(1.0, 3.0 * x * x), a / 2, b, epsabs=1e-14)
    exact = math.hypot(line + arc, along)
    assert abs(tape.length - exact) <= tape.error_estimate <= SMALL * exact
    assert tape.length == pytest.approx(exact, rel=2e-7)
    takeoff = tape.points[1:][tape.touching[1:]][0, 0]
    assert takeoff == pytest.approx(a / 2, abs=0.01)


@WAYS
def test_over_a_hill_between_hollows(along: float) -> None:
    hill = row_of(*HILL)
    tape = drawn(hill, (-3.0, 0.2), (3.0, 0.2 + along), "above")
    # The line from (3, 1) touches 2 - x^2 at 3 - sqrt(8).
    touch = 3.0 - math.sqrt(8.0)
    line = math.hypot(3.0 - touch, 1.0 - touch**2)
    exact = math.hypot(2.0 * (line + parabola_arc(touch)), along)
    assert abs(tape.length - exact) <= tape.error_estimate
    assert tape.length == pytest.approx(exact, rel=2e-7)


@WAYS
def test_over_a_sharp_edge(along: float) -> None:
    roof = row_of(*ROOF)
    tape = bm.taut_tape(
        roof, at(roof, -0.9, 0.3), at(roof, 0.7, 0.3 + along), outside="along normals"
    )
    exact = math.hypot(1.6 * math.sqrt(2.0), along)
    assert abs(tape.length - exact) <= tape.error_estimate
    assert tape.length == pytest.approx(exact, rel=1e-5)


def test_across_a_sharp_valley() -> None:
    roof = row_of(*ROOF)
    tape = drawn(roof, (-0.9, 0.3), (0.7, 1.3), "below")
    assert tape.length == pytest.approx(tape.chord, rel=1e-12)


def test_along_a_sharp_valley_that_arches() -> None:
    # A string pressed into the crease between two slopes, z = |x| - (y / 3)^2.
    crease = row_of(
        bicubic({(0, 0): -1, (1, 0): 1}, {(0, 1): 3}, {(0, 0): 1, (1, 0): -1, (0, 2): -1}),
        bicubic({(1, 0): 1}, {(0, 1): 3}, {(1, 0): 1, (0, 2): -1}),
    )
    tape = bm.taut_tape(
        crease, bm.AtlasPoint(0, 1.0, 0.1), bm.AtlasPoint(1, 0.0, 0.9), outside="along normals"
    )
    exact, _ = quad(lambda v: math.hypot(3.0, 2.0 * v), 0.1, 0.9)
    assert tape.length == pytest.approx(exact, rel=1e-8)
    np.testing.assert_allclose(tape.points[:, 0], 0.0, atol=1e-9)
    assert tape.touching.all()


@pytest.mark.parametrize("degree", quick([5, 3]))
def test_round_a_rational_sphere_the_taut_tape_is_a_great_circle(degree: int) -> None:
    nets = elevate(sphere_nets(), degree, degree)
    points, index = weld(project(nets), weights=nets[..., 3])
    sphere = bm.Atlas(points, index, bm.Unit.M, weights=nets[..., 3])
    start, end = bm.AtlasPoint(0, 0.3, 0.4), bm.AtlasPoint(6, 0.2, 0.7)
    tape = bm.taut_tape(sphere, start, end)
    first, last = sphere.position(start), sphere.position(end)
    exact = math.atan2(float(np.linalg.norm(np.cross(first, last))), float(first @ last))
    assert abs(tape.length - exact) <= tape.error_estimate <= 1e-6
    assert tape.gap <= tape.error_estimate
