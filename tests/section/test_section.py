"""Sections whose shapes are known, and changes that must not affect them."""

import math

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas, grid_index
from helpers.surfaces.quadrics import torus_nets
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID, PH_CYLINDER, PLANE
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation
from scipy.special import ellipe

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.bezier import elevate, restrict, split
from bodymeasure.errors import InputError
from bodymeasure.section import Plane, convex_hull, extent, plane_section

UP = (0.0, 0.0, 1.0)


def plane_at(point: ArrayLike, normal: ArrayLike) -> Plane:
    return Plane(np.asarray(point), np.asarray(normal))


def quadric(rows: int, a: float, b: float) -> Atlas:
    """The surface z = a x^2 + b y^2 over [-1, 1]^2, as rows x rows patches joined by index."""
    whole = np.zeros((4, 4, 3))
    thirds = np.linspace(-1.0, 1.0, 4)
    # x = 2u - 1; x^2 has the blossom x1 x2, whose mean over pairs of three arguments this is.
    square = np.array([1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0])
    whole[..., 0], whole[..., 1] = thirds[:, None], thirds
    whole[..., 2] = a * square[:, None] + b * square
    return cut(whole, rows)


def cut(net: Array, rows: int) -> Atlas:
    """One patch that is cut into rows x rows uneven patches, joined by index."""
    index = grid_index(rows, rows)
    at = np.linspace(0.0, 1.0, rows + 1) ** 1.2
    points = np.empty((index.max() + 1, 3))
    for number in range(rows * rows):
        i, j = divmod(number, rows)
        points[index[number]] = restrict(net, (at[i], at[j]), (at[i + 1], at[j + 1]))
    return Atlas(points, index, Unit.CM)


def ellipse(a: float, b: float) -> float:
    """The perimeter of the ellipse with half-axes a >= b."""
    return float(4.0 * a * ellipe(1.0 - (b / a) ** 2))


@pytest.mark.parametrize("rows", [1, 2, 3, 5])
@pytest.mark.parametrize("height", [1e-8, 1e-3, 0.0625, 0.25, 0.51, 0.9999])
def test_circles_on_a_paraboloid(rows: int, height: float) -> None:
    section = plane_section(quadric(rows, 1.0, 1.0), plane_at((0.0, 0.0, height), UP))
    (loop,) = section.loops
    assert loop.closed
    assert loop.unit == Unit.CM
    known = 2.0 * math.pi * math.sqrt(height)
    # This is the effect on a small circle of moving the plane by 1e-14 of the size.
    rounding = 1e-15 / height * known
    assert abs(loop.length - known) <= 1e-12 * known + loop.error_estimate
    assert loop.error_estimate <= 1e-9 + 10.0 * rounding
    hull = convex_hull(loop)
    assert hull.length <= loop.length
    assert abs(hull.length - known) <= 1e-11 * known + rounding + hull.error_estimate
    for direction in np.eye(3)[:2]:
        assert extent(loop, direction) == pytest.approx(
            2.0 * math.sqrt(height), rel=1e-12 + 1e-15 / height, abs=loop.error_estimate
        )


def test_estimates_hold_for_caps_that_the_plane_hardly_cuts_off() -> None:
    # The length of such a loop is proportional to the root of its height, so that rounding, and
    # moving the plane off corners, change it by far more than the plane moves.
    rng = np.random.default_rng(3)
    worst = 0.0
    for _ in range(40):
        a, b = np.exp(rng.uniform(-1.0, 1.0, 2))
        place = rng.uniform(-0.4, 0.4, 2)
        # The surface z = -a x^2 - b y^2, sheared so that its top lies anywhere on its patches.
        atlas = quadric(2, -a, -b)
        slope = np.array([2.0 * a, 2.0 * b]) * place
        top = float(slope @ place) / 2.0
        points = atlas.points + atlas.points[:, :2] @ slope[:, None] * np.array(UP)
        atlas = Atlas(points, atlas.index, atlas.unit)
        height = 10.0 ** rng.uniform(-11.5, -2.0)
        plane = plane_at((0.0, 0.0, top - height), UP)
        known = ellipse(*sorted(np.sqrt(height / np.array([a, b])), reverse=True))
        (loop,) = plane_section(atlas, plane).loops
        assert abs(loop.length - known) <= loop.error_estimate + 1e-14
        worst = max(worst, abs(loop.length - known) / known)
    assert worst > 1e-8


def test_points_lie_on_the_surface_and_in_the_plane() -> None:
    atlas = quadric(3, 1.0, 1.0)
    plane = plane_at((0.0, 0.1, 0.6), (0.2, 0.3, 1.0))
    (loop,) = plane_section(atlas, plane).loops
    again = [
        restrict(atlas.control_points[patch], uv, uv)[0, 0]
        for patch, uv in zip(loop.patch, loop.parameters, strict=True)
    ]
    np.testing.assert_allclose(loop.positions, again, atol=1e-14)
    np.testing.assert_allclose(plane.distances(loop.positions), 0.0, atol=1e-14)
    assert ((loop.parameters >= 0.0) & (loop.parameters <= 1.0)).all()
    steps = np.linalg.norm(np.diff(loop.positions, axis=0, append=loop.positions[:1]), axis=1)
    assert steps.sum() == pytest.approx(loop.length, rel=1e-2)
    assert steps.sum() < loop.length


@pytest.mark.parametrize("rows", [1, 3])
def test_ellipses(rows: int) -> None:
    (loop,) = plane_section(quadric(rows, 1.0, 3.0), plane_at((0.0, 0.0, 0.7), UP)).loops
    known = ellipse(math.sqrt(0.7), math.sqrt(0.7 / 3.0))
    assert loop.length == pytest.approx(known, rel=1e-13)
    assert convex_hull(loop).length == pytest.approx(known, rel=1e-12)
    points = np.concatenate([loop.positions, loop.positions[:1]])
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    centroid = chords @ (points[1:] + points[:-1]) / 2.0 / chords.sum()
    np.testing.assert_allclose(centroid, (0.0, 0.0, 0.7), atol=1e-3)


@pytest.mark.parametrize("rows", [1, 2, 4])
def test_tilted_plane_through_a_paraboloid(rows: int) -> None:
    # z = x^2 + y^2 and z = x / 2 + 0.3 meet in a circle about (1/4, 0), seen along z.
    slope, level = 0.5, 0.3
    (loop,) = plane_section(quadric(rows, 1.0, 1.0), plane_at((0, 0, level), (-slope, 0, 1))).loops
    radius = math.sqrt(level + slope**2 / 4.0)
    known = ellipse(radius * math.hypot(1.0, slope), radius)
    assert loop.length == pytest.approx(known, rel=1e-13)
    assert convex_hull(loop).length == pytest.approx(known, rel=1e-12)


def parabola(x: float) -> float:
    """The arc length of y = x^2 from 0."""
    return x / 2.0 * math.hypot(1.0, 2.0 * x) + math.asinh(2.0 * x) / 4.0


@pytest.mark.parametrize("rows", [1, 2, 4])
@pytest.mark.parametrize("y", [0.0, 0.3])
def test_open_parabolas(rows: int, y: float) -> None:
    # At 0 the plane would lie along cuts of the patch in halves; uneven cuts keep it inside
    # patches.
    (loop,) = plane_section(quadric(rows, 1.0, 1.0), plane_at((0.0, y, 0.0), (0.0, 1.0, 0.0))).loops
    assert not loop.closed
    assert loop.length == pytest.approx(2.0 * parabola(1.0), abs=1e-13 + loop.error_estimate)
    assert extent(loop, (1.0, 0.0, 0.0)) == pytest.approx(2.0, abs=1e-13)
    with pytest.raises(InputError, match=r"the section is open.*choose a plane"):
        convex_hull(loop)


def test_sections_of_a_plane_are_chords() -> None:
    # The surface is z = (x + 2y) / 2 over uneven parameters; the plane x = 1 cuts it from side to
    # side.
    (loop,) = plane_section(cut(PLANE, 2), plane_at((1.0, 0.0, 0.0), (1.0, 0.0, 0.0))).loops
    chord = np.linalg.norm(loop.positions[-1] - loop.positions[0])
    assert loop.length == pytest.approx(chord, rel=1e-14)
    assert loop.length > 0.0


def test_profile_of_a_cylinder() -> None:
    # A plane perpendicular to the rulings cuts out the profile, whose arc length is 3u + u^3.
    (loop,) = plane_section(cut(PH_CYLINDER, 3), plane_at((0.0, 0.0, 1.234), UP)).loops
    assert loop.length == pytest.approx(4.0, rel=1e-14)
    # The planes x = 2 and x = 11/8 cut out rulings, since x = 3u - u^3 is 2 only at u = 1 and 11/8
    # at u = 1/2.
    (loop,) = plane_section(cut(PH_CYLINDER, 3), plane_at((11 / 8, 0, 0), (1, 0, 0))).loops
    assert loop.length == pytest.approx(3.0, rel=1e-14)


def test_a_hollow_is_bridged() -> None:
    # z = x^2 + y^2 + 40 x^2 y^2 at z = 0.6 is a star with four points on the axes; in polar form,
    # r^2 + 10 r^4 sin^2(2a) = 0.6, whose length and hull come from dense points.
    net = quadric(1, 1.0, 1.0).control_points[0].copy()
    square = np.array([1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0])
    net[..., 2] += 40.0 * square[:, None] * square
    (loop,) = plane_section(cut(net, 3), plane_at((0.0, 0.0, 0.6), UP)).loops
    angle = np.linspace(0.0, 2.0 * np.pi, 2**17, endpoint=False)
    twist = np.sin(2.0 * angle) ** 2
    radius = np.sqrt(2.0 * 0.6 / (1.0 + np.sqrt(1.0 + 40.0 * 0.6 * twist)))
    curve = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1)
    slope = -20.0 * radius**3 * np.sin(4.0 * angle) / (2.0 + 40.0 * radius**2 * twist)
    # The trapezoidal rule is accurate on a periodic function.
    known = 2.0 * np.pi * np.hypot(radius, slope).mean()
    assert loop.length == pytest.approx(known, rel=1e-12)

    hull = convex_hull(loop)
    # By Cauchy's formula the perimeter is the integral of the support function.
    normals = 2.0 * np.pi * (np.arange(4096) + 0.5) / 4096
    direction = np.stack([np.cos(normals), np.sin(normals)])
    coarse = curve[::16]
    support = np.array([(coarse @ column).max() for column in direction.T])
    assert hull.length == pytest.approx(2.0 * np.pi * support.mean(), rel=2e-6)
    assert hull.length < loop.length * (1.0 - 1e-4)
    assert len(hull.bridges) == 4
    # No point of the loop lies outside a bridge.
    for start, end in hull.bridges:
        outward = np.cross(end - start, UP)
        outward *= np.sign(outward @ (start + end))
        assert ((loop.positions - start) @ outward).max() <= 1e-12


def test_an_island_inside_one_patch_and_curves_of_a_saddle() -> None:
    assert len(plane_section(quadric(1, 1.0, 1.0), plane_at((0, 0, 1.5), UP)).loops) == 4
    assert len(plane_section(quadric(1, 1.0, -1.0), plane_at((0, 0, 1e-6), UP)).loops) == 2
    assert len(plane_section(quadric(3, 1.0, -1.0), plane_at((0, 0, -1e-6), UP)).loops) == 2


@pytest.mark.parametrize("net", [ENNEPER, PARABOLOID, PH_CYLINDER], ids=["enneper", "p", "c"])
def test_splitting_moving_and_scaling_change_nothing(net: Array, rng: np.random.Generator) -> None:
    whole = Atlas.from_control_points(net, Unit.CM)
    middle = net.mean(axis=(0, 1))
    for _ in range(8):
        normal = rng.normal(size=3)
        plane = plane_at(middle + 0.1 * rng.normal(size=3), normal)
        known = [loop.length for loop in plane_section(whole, plane).loops]
        assert known
        for rows in (2, 4, 8):
            lengths = [loop.length for loop in plane_section(cut(net, rows), plane).loops]
            np.testing.assert_allclose(lengths, known, rtol=1e-11)

        turn = Rotation.random(random_state=int(rng.integers(1000))).as_matrix()
        moved = Atlas.from_control_points(1e3 * (net @ turn.T) + (5.0, -4.0, 3.0), Unit.CM)
        there = plane_at(1e3 * turn @ plane.point + (5.0, -4.0, 3.0), turn @ normal)
        lengths = [loop.length for loop in plane_section(moved, there).loops]
        np.testing.assert_allclose(lengths, 1e3 * np.array(known), rtol=1e-11)


@pytest.mark.parametrize("degree", [4, 5, 9])
def test_sections_do_not_depend_on_the_degree(degree: int, rng: np.random.Generator) -> None:
    for nets in (ENNEPER, torus_nets(2.0, 0.7)[0]):
        whole = Atlas.from_control_points(elevate(nets, 3, 3), Unit.CM)
        raised = Atlas.from_control_points(elevate(nets, degree, degree), Unit.CM)
        for _ in range(4):
            plane = plane_at(whole.points[5] + 0.1 * rng.normal(size=3), rng.normal(size=3))
            known = [loop.length for loop in plane_section(whole, plane).loops]
            lengths = [loop.length for loop in plane_section(raised, plane).loops]
            np.testing.assert_allclose(lengths, known, rtol=1e-12)
    # This plane misses the patch.
    assert not plane_section(raised, plane_at((0.0, 0.0, 9.0), UP)).loops


def test_a_plane_through_seams_and_corners() -> None:
    # In even halves x = 0 is a seam, and x = y passes through corners.
    net = quadric(1, 1.0, 1.0).control_points[0]
    halves = split(net)
    index = grid_index(2, 2)
    points = np.empty((index.max() + 1, 3))
    points[index] = halves.reshape(4, 4, 4, 3)
    atlas = Atlas(points, index, Unit.CM)
    (loop,) = plane_section(atlas, plane_at((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))).loops
    assert loop.length == pytest.approx(2.0 * parabola(1.0), abs=1e-10)
    assert 1e-12 < loop.error_estimate < 1e-9
    (loop,) = plane_section(atlas, plane_at((0.0, 0.0, 0.0), (1.0, -1.0, 0.0))).loops
    assert loop.length == pytest.approx(2.0 * parabola(math.sqrt(2.0)), abs=1e-9)


@pytest.mark.parametrize("end", [0.0, 1.0])
def test_a_boundary_that_lies_in_the_plane_is_its_section(end: float) -> None:
    atlas = grid_atlas(2, 3)
    (loop,) = plane_section(atlas, plane_at((2.0 * end, 0.0, 0.0), (1.0, 0.0, 0.0))).loops
    assert loop.length == pytest.approx(3.0, abs=1e-9)
    # A corner that only touches the plane leaves no section.
    assert plane_section(atlas, plane_at((2.0 * end, 3.0 * end, 0.0), (1.0, 1.0, 0.0))).loops == ()


def test_a_plane_that_touches_is_refused() -> None:
    with pytest.raises(InputError, match=r"touches the surface of patch 'patch 0'.*move the plane"):
        plane_section(quadric(1, 1.0, 1.0), plane_at((0.0, 0.0, 0.0), UP))
    with pytest.raises(InputError, match="touches the surface of patch"):
        plane_section(quadric(1, 1.0, -1.0), plane_at((0.0, 0.0, 0.0), UP))


def test_a_plane_in_which_a_patch_lies_is_refused() -> None:
    with pytest.raises(InputError, match=r"patch 'patch 0' lies in the plane through.*tilt"):
        plane_section(grid_atlas(2, 2), plane_at((0.3, 0.0, 0.0), UP))


def test_a_plane_that_misses() -> None:
    section = plane_section(quadric(2, 1.0, 1.0), plane_at((0.0, 0.0, -0.1), UP))
    assert section.loops == ()
    with pytest.raises(InputError, match="misses the body; move it to where the body is"):
        section.nearest((0.0, 0.0, 0.0))


def test_an_edge_of_three_patches_is_refused() -> None:
    flat = grid_atlas(1, 2).points
    third = flat[grid_index(1, 2)[1]] * (1.0, 0.0, 0.0) + (0.0, 1.0, 0.0)
    third[..., 2] = np.linspace(0.0, 1.0, 4)
    index = np.concatenate(
        [grid_index(1, 2), np.arange(len(flat), len(flat) + 16).reshape(1, 4, 4)]
    )
    index[2, :, 0] = index[1, :, 0]
    points = np.concatenate([flat, third.reshape(-1, 3)])
    atlas = Atlas(points, index, Unit.CM)
    with pytest.raises(InputError, match="an edge belongs to more than two patches"):
        plane_section(atlas, plane_at((0.4, 0.0, 0.0), (1.0, 0.0, 0.0)))


def test_the_nearest_loop_is_chosen() -> None:
    section = plane_section(quadric(2, 1.0, -1.0), plane_at((0.0, 0.0, 0.25), UP))
    left, right = (section.nearest((x, 0.0, 0.25)) for x in (-1.0, 1.0))
    assert left.positions.mean(axis=0)[0] < 0.0 < right.positions.mean(axis=0)[0]
