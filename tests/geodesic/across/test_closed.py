"""Closed geodesics: loops that contract, on surfaces whose waists are known."""

import math
from dataclasses import replace

import numpy as np
import potpourri3d
import pytest
from helpers.body_space import body_of
from helpers.speed import quick
from helpers.surfaces.quadrics import joined, line, revolved, torus_nets
from helpers.surfaces.tubes import ring_length, tube
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit, tessellate
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import restrict
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic import ClosedPath, LoopKind, Status, contracted_loop
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.error import route_length
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine
from bodymeasure.geodesic.across.routes.through import route_through
from bodymeasure.measure import closed_geodesic
from bodymeasure.section import Plane, plane_section

WAISTED = (2.0, 1.0, 1.0, 2.0)


def at(x: float, y: float, z: float) -> Array:
    return np.array([x, y, z])


def section(atlas: Atlas, point: Array, normal: Array) -> list[AtlasPoint]:
    """Points along the plane section through a point."""
    loop = plane_section(atlas, Plane(point, normal)).nearest(point)
    pairs = zip(loop.patch.tolist(), loop.parameters.tolist(), strict=True)
    return [AtlasPoint(patch, *uv) for patch, uv in pairs]


def welded(nets: Array) -> Atlas:
    """Patches joined where their control points agree to eleven digits."""
    points = nets.reshape(-1, 3)
    _, first, number = np.unique(
        np.round(points + 0.123456789e-5, 11), axis=0, return_index=True, return_inverse=True
    )
    return Atlas(points[first], number.reshape(-1, 4, 4), Unit.CM)


def split(atlas: Atlas, us: tuple[float, ...], vs: tuple[float, ...]) -> Atlas:
    """The atlas with every patch cut along parameter lines."""
    u, v = (0.0, *us, 1.0), (0.0, *vs, 1.0)
    return welded(
        np.array(
            [
                restrict(net, (u[i], v[j]), (u[i + 1], v[j + 1]))
                for net in atlas.control_points
                for i in range(len(u) - 1)
                for j in range(len(v) - 1)
            ]
        )
    )


def dented(rng: np.random.Generator) -> Atlas:
    """A waisted tube without symmetry, whose seams are smooth or kinked at random."""
    atlas = tube(WAISTED)
    points = atlas.points.copy()
    inner = (points[:, 2] > 0.0) & (points[:, 2] < 3.0)
    points[inner] += rng.uniform(-0.12, 0.12, (inner.sum(), 3))
    return replace(atlas, points=points)


def slanting(atlas: Atlas) -> list[AtlasPoint]:
    return section(atlas, at(0.0, 0.0, 1.1), at(0.2, -0.1, 1.0))


@pytest.mark.parametrize("point", [(0.0, 0.0, 0.5), (0.0, 0.0, 1.5), (0.0, 0.0, 2.2)])
def test_a_waist(point: tuple[float, float, float]) -> None:
    atlas = tube(WAISTED)
    path = contracted_loop(atlas, section(atlas, np.array(point), at(0.1, 0.15, 1.0)))
    known = 1.25 * ring_length()
    assert path.length == pytest.approx(known, rel=1e-12)
    assert abs(path.length - known) <= path.error_estimate
    assert path.error_estimate < 1e-9 * known
    assert (path.status, path.kind, path.local_minimum) == (
        Status.CONVERGED,
        LoopKind.MINIMUM,
        True,
    )
    positions = path.position(np.linspace(0.0, 1.0, 101))
    assert positions[:, 2] == pytest.approx(1.5, abs=1e-7)
    assert positions[0] == pytest.approx(positions[-1], abs=1e-13)
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    assert steps == pytest.approx(path.length / 100, rel=2e-3)
    assert len(path.crossings) == len(path.pieces) == 4
    assert [crossing.t for crossing in path.crossings] == pytest.approx([0.0, 0.25, 0.5, 0.75])
    for crossing in path.crossings:
        assert atlas.position(crossing.before) == pytest.approx(atlas.position(crossing.after))


def hyperboloid(neck: float, width: float) -> Atlas:
    """r^2 / neck^2 - z^2 = 1 between z = -sinh(width) and sinh(2 width)."""
    nets = []
    for low, high in ((-width, 0.3 * width), (0.3 * width, 2.0 * width)):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        ends = [(math.cosh(t), math.sinh(t)) for t in (low, high)]
        apex = (math.cosh(middle), math.sinh(middle))
        # The middle point has the weight cosh(half), by which its distance from the center is
        # divided.
        profile = np.array([[*ends[0], 1.0], [*apex, math.cosh(half)], [*ends[1], 1.0]])
        nets += [revolved(profile * (neck, 1.0, 1.0), number) for number in range(4)]
    return joined(np.array(nets))


@pytest.mark.parametrize("neck", quick([0.3, 1.0, 4.0]))
def test_the_neck_of_a_hyperboloid(neck: float) -> None:
    atlas = hyperboloid(neck, 0.8)
    path = contracted_loop(atlas, section(atlas, at(0.0, 0.0, 0.7), at(0.02, 0.04, 1.0)))
    assert path.length == pytest.approx(2.0 * math.pi * neck, rel=1e-10)
    assert abs(path.length - 2.0 * math.pi * neck) <= path.error_estimate
    assert path.local_minimum


def test_the_inner_circle_of_a_torus() -> None:
    atlas = joined(torus_nets(2.0, 0.5))
    inner = contracted_loop(atlas, section(atlas, at(1.6, 0.0, 0.2), at(0.02, 0.01, 1.0)))
    assert inner.length == pytest.approx(2.0 * math.pi * 1.5, rel=1e-10)
    assert inner.local_minimum
    through = contracted_loop(atlas, section(atlas, at(2.0, 0.5, 0.0), at(0.0, 1.0, 0.1)))
    assert through.length == pytest.approx(2.0 * math.pi * 0.5, rel=1e-10)


def test_one_of_a_family_says_so() -> None:
    atlas = tube([1.0] * 4)
    path = contracted_loop(atlas, section(atlas, at(0.0, 0.0, 1.2), at(0.3, 0.1, 1.0)))
    assert path.length == pytest.approx(ring_length(), rel=1e-12)
    assert path.error_estimate < 1e-9
    assert (path.status, path.kind) == (Status.CONVERGED, LoopKind.FLAT)
    assert not path.local_minimum
    assert "one of a family" in path.kind.value


@pytest.mark.slow
def test_a_loop_that_only_balances_is_no_minimum() -> None:
    atlas = joined(torus_nets(2.0, 0.5))
    # If the loop starts exactly on the outer circle, rounding decides whether it stays.
    outer = section(atlas, at(2.5, 0.0, 0.0), at(0.0, 0.0, 1.0))
    path = contracted_loop(atlas, outer, on_failure="status")
    if path.status is Status.NOT_A_MINIMUM:
        assert path.kind is LoopKind.SADDLE
        assert math.isnan(path.length)
        assert path.raw_length == pytest.approx(2.0 * math.pi * 2.5, rel=1e-10)
        with pytest.raises(ConvergenceError, match="it only balances"):
            contracted_loop(atlas, outer)
    else:
        assert path.length == pytest.approx(2.0 * math.pi * 1.5, rel=1e-10)


@pytest.mark.parametrize(
    ("radii", "kind", "radius"),
    [
        ([1.0, 2.0, 2.0, 1.0], LoopKind.SADDLE, 1.75),
        ([2.0, 1.0, 1.0, 2.0], LoopKind.MINIMUM, 1.25),
        ([1.0, 1.0, 1.0, 1.0], LoopKind.FLAT, 1.0),
    ],
)
def test_the_kind_is_read_off_the_second_variation(
    radii: list[float], kind: LoopKind, radius: float
) -> None:
    atlas = tube(radii)
    places = list(section(atlas, at(0, 0, 1.5), at(0, 0, 1)))
    route = route_through(Neighbors(atlas), places)
    # A quarter of the ring is a cubic in (u, v) = (t, 1/2), so that this loop is exact.
    length, found = route_length(refine(atlas, route, 3, radius * ring_length()))
    assert found is kind
    assert length.corrected == pytest.approx(radius * ring_length(), rel=1e-9)


def test_a_loop_that_slides_to_the_boundary_says_so() -> None:
    atlas = tube([1.0, 2.0, 2.0, 1.0])
    path = contracted_loop(atlas, section(atlas, at(0.0, 0.0, 1.3), at(0.0, 0.0, 1.0)))
    assert path.status is Status.ON_BOUNDARY
    assert abs(path.length - ring_length()) <= path.error_estimate + 1e-12
    assert path.error_estimate < 1e-4 * path.length


def test_what_changes_nothing(rng: np.random.Generator) -> None:
    atlas = dented(rng)
    path = contracted_loop(atlas, slanting(atlas))
    backwards = contracted_loop(atlas, slanting(atlas)[::-1])
    later = contracted_loop(atlas, slanting(atlas)[5:] + slanting(atlas)[:5])
    from_above = contracted_loop(atlas, section(atlas, at(0.0, 0.0, 2.0), at(0.1, 0.0, 1.0)))
    for other in (backwards, later, from_above):
        assert other.length == pytest.approx(path.length, rel=1e-10)
    turn = Rotation.random(random_state=7).as_matrix()
    moved = replace(atlas, points=3.0 * atlas.points @ turn.T + (5.0, -2.0, 1.0))
    again = contracted_loop(moved, slanting(atlas))
    assert again.length == pytest.approx(3.0 * path.length, rel=1e-10)
    assert again.kind is path.kind


@pytest.mark.parametrize(
    ("us", "vs"),
    [
        ((0.4,), ()),
        ((), (0.45,)),
        pytest.param((0.3, 0.7), (0.2, 0.5, 0.8), marks=pytest.mark.slow),
    ],
)
def test_splits_change_nothing(
    us: tuple[float, ...], vs: tuple[float, ...], rng: np.random.Generator
) -> None:
    atlas = dented(rng)
    parts = split(atlas, us, vs)
    whole, cut = (contracted_loop(each, slanting(each)) for each in (atlas, parts))
    assert cut.length == pytest.approx(whole.length, rel=1e-9)
    assert abs(cut.length - whole.length) <= cut.error_estimate + whole.error_estimate


def edge_flip_loop(atlas: Atlas, segments: int) -> float:
    """The length of the loop to which edge flips contract a ring of mesh edges."""
    mesh = tessellate(atlas, segments)
    near = [
        int(np.argmin(np.linalg.norm(mesh.vertices - at(x, y, 1.5), axis=1)))
        for x, y in ((2.0, 0.0), (0.0, 2.0), (-2.0, 0.0), (0.0, -2.0))
    ]
    solver = potpourri3d.EdgeFlipGeodesicSolver(mesh.vertices, mesh.faces)
    points = solver.find_geodesic_loop(near)
    return float(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum())


@pytest.mark.parametrize("number", range(3))
def test_edge_flips_on_meshes_agree(number: int, rng: np.random.Generator) -> None:
    for _ in range(number + 1):
        atlas = dented(rng)
    path = contracted_loop(atlas, slanting(atlas))
    coarse, fine = (edge_flip_loop(atlas, n) / path.length - 1.0 for n in (32, 64))
    # Loops over meshes of surfaces with kinks get better with their steps.
    assert abs(coarse) < 3e-4
    assert abs(fine) < 0.7 * abs(coarse)
    assert abs(2.0 * fine - coarse) < 4e-5


def test_mistakes_are_named() -> None:
    atlas = tube(WAISTED)
    loop = section(atlas, at(0, 0, 1), at(0, 0, 1))
    with pytest.raises(InputError, match="the loop has 2 points; expected at least 3"):
        contracted_loop(atlas, loop[:2])
    with pytest.raises(InputError, match=r"patches 0 and 2, which meet at neither.*each seam"):
        contracted_loop(atlas, [AtlasPoint(patch, 0.5, 0.5) for patch in (0, 2, 3)])
    with pytest.raises(InputError, match=r"point 1 of the loop has .* expected both in"):
        contracted_loop(atlas, [loop[0], AtlasPoint(0, 2.0, 0.0), loop[1]])
    with pytest.raises(InputError, match="on_failure is 'ignore'; expected 'raise' or 'status'"):
        contracted_loop(atlas, loop, on_failure="ignore")  # type: ignore[arg-type]


def test_a_loop_round_nothing_is_refused() -> None:
    atlas = tube(WAISTED)
    with pytest.raises(InputError, match=r"contracts to a point.*round the trunk or a limb"):
        contracted_loop(atlas, [AtlasPoint(0, *uv) for uv in ((0.2, 0.3), (0.4, 0.3), (0.3, 0.5))])
    # This loop goes over a seam and back.
    places = [(0, 0.9, 0.3), (0, 1.0, 0.3), (1, 0.1, 0.35), (1, 0.0, 0.4), (0, 0.9, 0.4)]
    with pytest.raises(InputError, match="contracts to a point"):
        contracted_loop(atlas, [AtlasPoint(*place) for place in places])
    # This loop goes around a corner of four patches.
    parts = split(atlas, (0.5,), (0.5,))
    places = [(0, 0.9, 0.9), (0, 1.0, 0.9), (2, 0.1, 0.9), (2, 0.1, 1.0), (3, 0.1, 0.1)]
    places += [(3, 0.0, 0.1), (1, 0.9, 0.1), (1, 0.9, 0.0)]
    with pytest.raises(InputError, match="contracts to a point"):
        contracted_loop(parts, [AtlasPoint(*place) for place in places])


def test_cylinders_of_lines() -> None:
    nets = np.array([revolved(line((1.0, -1.0), (1.0, 1.0)), number) for number in range(4)])
    atlas = joined(nets)
    path: ClosedPath = contracted_loop(atlas, section(atlas, at(0.0, 0.0, 0.0), at(0.4, 0.0, 1.0)))
    assert path.length == pytest.approx(2.0 * math.pi, rel=1e-10)
    assert path.kind is LoopKind.FLAT


@pytest.mark.slow
def test_a_loop_that_has_no_length_takes_no_more_work_than_others(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where a body is folded at the waist, each detour at each degree once took seconds."""
    work: list[float] = []

    def spend(budget: Budget, refined: RefinedPath) -> None:
        before = budget.left
        counted(budget, refined)
        work.append(before - budget.left)

    counted = Budget.spend
    monkeypatch.setattr(Budget, "spend", spend)
    body = body_of(np.random.default_rng(101).standard_normal(40))
    place = "side waist point left"
    loop = closed_geodesic(body, place, on_failure="status")
    assert loop.status is Status.NOT_CONVERGED
    assert math.isnan(loop.length)
    assert sum(work) < 1.2e7
