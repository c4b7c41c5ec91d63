"""The shortest path inside a patch: contact with edges, several candidates, saddles."""

import numpy as np
import pytest
from helpers.surfaces.height_fields import bent_plane, heights
from scipy.optimize import brentq

import bodymeasure as bm
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.contact.legs import read_legs
from bodymeasure.geodesic.contact.solve import solve_contact_paths
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.oracle import mesh_distances

START, END = np.zeros(2), np.ones(2)


def test_a_flat_patch_with_an_edge_in_the_way() -> None:
    # The edge u = 0 is x = 2.4 v (1 - v), y = v: from (0, 0) to (0, 1) the shortest way in the
    # patch is along it, and the straight line is outside.
    net = bent_plane()
    solution = bm.solve_geodesic(net, (0.0, 0.0), (0.0, 1.0))
    assert solution.status is bm.Status.ON_BOUNDARY
    t = np.linspace(0.0, 1.0, 20001)
    x, y = 2.4 * t * (1.0 - t), t
    along = np.hypot(np.diff(x), np.diff(y)).sum()
    assert solution.length == pytest.approx(along, rel=1e-8)
    (contact,) = solution.contacts
    assert contact.edge == "u = 0"
    assert (contact.start, contact.end) == (0.0, 1.0)


def test_tangent_to_an_arc_and_away_from_it() -> None:
    # The path leads from (0, 0) along the bulging edge, then straight and tangentially to (0.3, 1):
    # the hull of the obstacle, which elementary geometry gives.
    net = bent_plane()
    solution = bm.solve_geodesic(net, (0.0, 0.0), (0.3, 1.0))
    assert solution.status is bm.Status.ON_BOUNDARY
    target = np.array([0.3, 1.0])  # on v = 1, x = u

    def slope_difference(t: float) -> float:
        point = np.array([2.4 * t * (1.0 - t), t])
        tangent = np.array([2.4 * (1.0 - 2.0 * t), 1.0])
        way = target - point
        return float(tangent[0] * way[1] - tangent[1] * way[0])

    leave = brentq(slope_difference, 0.1, 0.9, xtol=1e-14)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    t = leave * (nodes + 1.0) / 2.0
    arc = leave / 2.0 * weights @ np.hypot(2.4 * (1.0 - 2.0 * t), 1.0)
    free = np.linalg.norm(target - np.array([2.4 * leave * (1.0 - leave), leave]))
    assert solution.length == pytest.approx(arc + free, rel=1e-11)
    assert abs(solution.length - (arc + free)) <= solution.error_estimate
    (contact,) = solution.contacts
    assert contact.edge == "u = 0"
    assert contact.start == 0.0
    assert contact.end == pytest.approx(leave, abs=1e-6)
    path = solution.path(np.linspace(0.0, 1.0, 301))
    assert (path >= -1e-9).all()
    assert (path <= 1.0 + 1e-9).all()
    assert path[0] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert path[-1] == pytest.approx([0.3, 1.0], abs=1e-12)


def test_contact_between_two_free_pieces() -> None:
    # Between points off the edge on both sides of the bulge the path is free, along it, and free.
    net = bent_plane()
    start, end = (0.1, 0.05), (0.1, 0.95)
    there = bm.solve_geodesic(net, start, end)
    back = bm.solve_geodesic(net, end, start)
    (contact,) = there.contacts
    assert 0.05 < contact.start < 0.5 < contact.end < 0.95
    # The patch is its own mirror image in v = 1/2.
    assert contact.start + contact.end == pytest.approx(1.0, abs=1e-6)
    assert back.length == pytest.approx(there.length, rel=1e-10)
    chord = 0.9
    assert there.length > chord


def test_a_wall_round_the_straight_line_is_gone_round() -> None:
    # A ridge across the diagonal that is symmetric about it: going over it straight is a geodesic,
    # round either side is shorter, and the two sides are equally long.
    z = np.zeros((4, 4))
    z[1:3, 1:3] = 2.0
    net = heights(z)
    quick = bm.solve_geodesic(net, START, END, on_failure="status")
    thorough = bm.solve_geodesic(net, START, END, search="thorough")
    over = bm.solve_geodesic(net, START, END, search="straight", on_failure="status")
    assert not over.local_minimum
    assert np.isnan(over.length)
    assert over.raw_length > 1.05 * thorough.length
    assert quick.length == pytest.approx(thorough.length, rel=1e-9)
    mesh = mesh_distances(net[None], START[None, None], END[None, None])
    difference = thorough.length - mesh.exact[0, 0]
    assert abs(difference) <= 3.0 * mesh.exact_uncertainty[0, 0]


def test_a_search_is_one_of_three() -> None:
    with pytest.raises(bm.InputError, match="search is 'slow'; expected one of quick, thorough"):
        bm.solve_geodesic(heights(np.zeros((4, 4))), START, END, search="slow")  # type: ignore[arg-type]


def test_where_the_search_does_not_apply_the_method_speaks_for_itself() -> None:
    net = bent_plane()
    given = bm.solve_geodesic(
        net, (0.0, 0.0), (0.0, 1.0), method=bm.RBFCollocation(), on_failure="status"
    )
    assert given.status is bm.Status.LEAVES_PATCH
    assert np.isnan(given.length)
    assert given.contacts == ()
    searched = bm.solve_geodesic(
        net, (0.0, 0.0), (0.0, 1.0), method=bm.RBFCollocation(), search="quick"
    )
    assert searched.status is bm.Status.ON_BOUNDARY


@pytest.mark.slow
@pytest.mark.parametrize(
    ("side", "symmetric", "least_solved"), [(1.0, False, 1.0), (0.6, False, 0.9), (1.0, True, 1.0)]
)
def test_wild_patches_against_meshes(
    rng: np.random.Generator, side: float, symmetric: bool, least_solved: float
) -> None:
    count = 40
    z = rng.integers(0, 6, (count, 4, 4)) / 5.0
    if symmetric:
        lower = np.tril(z)
        z = lower + np.swapaxes(np.tril(z, -1), 1, 2)
    z[:, 0, 0], z[:, 3, 3] = 0.0, 1.0
    nets = np.array([heights(each, side) for each in z])
    solution = bm.solve_geodesic(nets, START, END, search="thorough", on_failure="status")
    solved = solution.converged
    assert solved.mean() >= least_solved
    mesh = mesh_distances(
        nets, np.broadcast_to(START, (count, 1, 2)), np.broadcast_to(END, (count, 1, 2))
    )
    difference = solution.length - mesh.exact[:, 0]
    allowed = 3.0 * mesh.exact_uncertainty[:, 0] + 1e-6 * mesh.exact[:, 0]
    assert (np.abs(difference)[solved] <= allowed[solved]).all()


@pytest.mark.parametrize(("x", "clear"), [(0.61, True), (0.59, False)])
def test_an_arc_of_one_point_does_not_run_backwards(x: float, clear: bool) -> None:
    # A vertical chord at x, and one vertex of its polygon on the edge, which bulges to x = 0.6. If
    # the chord clears the bulge, both tangents from the ends touch the edge past one another.
    net = bent_plane()
    y = np.linspace(0.3, 0.7, 65)
    edge = 2.4 * y * (1.0 - y)
    polygon = np.stack([np.maximum((x - edge) / (1.0 - edge), 1e-9), y], axis=1)
    polygon[32, 0] = 0.0
    legs = read_legs(polygon)
    assert [(leg.first, leg.last) for leg in legs] == [(0, 32), (32, 32), (32, 64)]
    path = solve_contact_paths(BezierSurfaces(net[None]), [polygon], [(None, None)], 1e-9)[0]
    assert path is not None
    if clear:
        # The pattern was read again, and the chord was found.
        assert path.contacts == ()
        assert path.length.corrected[0] == pytest.approx(0.4, rel=1e-9)
    else:
        assert path.contacts[0].start < path.contacts[0].end


def test_a_way_that_the_graph_takes_for_much_longer() -> None:
    # On heights of eleven sides the lengths of the graph are 5 and 28 % too long, and the longer
    # way there is the shorter one. Its length is that of inscribed polygons of 80,000 and 160,000
    # edges, extrapolated; a path of 1.8395 is a minimum, too.
    z = [
        [-1.0810865360705328, 1.8938345665032683, -6.2720812561900345, 2.376843272735286],
        [2.815827854585804, 2.4818108875932587, 6.241663127443349, 3.933354447671656],
        [-1.1593717177199179, -3.584833821337353, -6.754793394249916, -0.7966727736282762],
        [6.942959213865311, -7.161708259482665, 11.163901737797252, -0.9453346605595308],
    ]
    start = (0.5460883365226716, 0.00027233940266302437)
    end = (0.633104411589652, 1.0)
    solution = bm.solve_geodesic(heights(np.array(z)), start, end)
    assert solution.length == pytest.approx(1.72039439541, rel=2e-10)
    assert solution.error_estimate <= 2e-10


def test_a_shorter_way_that_cannot_be_made_exact_is_not_kept_quiet(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # On this patch the straight start is a geodesic, and a way round the ridge is shorter.
    z = np.zeros((4, 4))
    z[1:3, 1:3] = 2.0
    net = heights(z)
    loose = bm.RBFCollocation(tolerance=1e-3)
    shorter = bm.solve_geodesic(net, START, END, search="thorough").length
    for module in ("shortest.exact_paths", "contact.free_legs"):
        monkeypatch.setattr(f"bodymeasure.geodesic.{module}.LOWER_DEGREES", (2,))
    monkeypatch.setattr("bodymeasure.geodesic.elements.solve.MOST_WORK", 0)
    kept = bm.solve_geodesic(net, START, END, method=loose, search="thorough", on_failure="status")
    assert kept.raw_length > 1.02 * shorter
    assert not kept.converged


LEVELS = {
    "a long arc and a sharp bend": [[0, 2, 2, 2], [1, 5, 4, 0], [4, 5, 4, 0], [1, 0, 0, 5]],
    "an arc into the far corner": [[0, 2, 5, 3], [5, 3, 3, 2], [5, 3, 0, 3], [1, 0, 0, 5]],
    # The arc is shorter than a thousandth of the edge: no polygon shows it, and the free path
    # leaves.
    "an arc too short for polygons": [[0, 2, 2, 5], [1, 0, 4, 5], [0, 2, 3, 2], [0, 5, 0, 5]],
    "a short arc and a sharp bend": [[0, 4, 0, 0], [5, 0, 0, 1], [2, 1, 0, 4], [4, 0, 0, 5]],
}
SLOW = ("an arc too short for polygons", "a short arc and a sharp bend")


@pytest.mark.parametrize(
    "levels",
    [
        pytest.param(levels, id=name, marks=[pytest.mark.slow] if name in SLOW else [])
        for name, levels in LEVELS.items()
    ],
)
def test_paths_along_edges_of_wild_patches(levels: list[list[int]]) -> None:
    net = heights(np.array(levels) / 5.0, side=0.6)
    solution = bm.solve_geodesic(net, START, END)
    assert solution.status is bm.Status.ON_BOUNDARY
    assert solution.error_estimate < 1e-9
    back = bm.solve_geodesic(net, END, START)
    assert back.length == pytest.approx(solution.length, rel=1e-9)
    # A polygon on it is shorter by a part of the order of its edges squared.
    points = solution.path(np.linspace(0.0, 1.0, 129))
    edges = np.linalg.norm(np.diff(evaluate(net, points), axis=0), axis=1).sum()
    assert 0.0 < solution.length - edges < 3e-3


@pytest.mark.parametrize("search", ["quick", "thorough"])
@pytest.mark.parametrize("along", [(0.0, 0.01, 0.02, 1.0), (0.0, 0.98, 0.99, 1.0)])
def test_a_straight_edge_of_uneven_speed_holds_its_path(
    along: tuple[float, ...], search: bm.geodesic.Search
) -> None:
    # No method resolves the parameter, and the polygon lies on the edge but for rounding errors.
    net = heights(np.zeros((4, 4)))
    net[..., 1] = along
    solution = bm.solve_geodesic(net, (0.0, 0.0), (0.0, 1.0), search=search)
    assert solution.length == pytest.approx(1.0, rel=1e-14)
    (contact,) = solution.contacts
    assert (contact.edge, contact.start, contact.end) == ("u = 0", 0.0, 1.0)


def test_a_shallow_saddle_is_left() -> None:
    # Symmetric about the diagonal, on which lies a geodesic with an eigenvalue of -6e-4. Beside it
    # are two that are shorter by 6e-8.
    levels = [[0, 5, 0, 4], [5, 4, 4, 4], [0, 4, 2, 1], [4, 4, 1, 5]]
    net = heights(np.array(levels) / 5.0)
    over = bm.solve_geodesic(net, START, END, search="straight", on_failure="status")
    assert over.index == 1
    beside = bm.solve_geodesic(net, START, END)
    assert beside.local_minimum
    assert 1e-8 < over.raw_length - beside.length < 1e-6
    u, v = beside.path(0.5)
    assert abs(u - v) > 1e-3


@pytest.mark.parametrize(
    "z",
    [
        "-2.84 -.12 2.51 1.95  1.67 .85 -1.38 .34  -1.46 3.57 .64 1.55  -2.77 2.31 -.91 .56",
        "-.92 -.23 -.07 .41  .56 .2 -.08 -1.37  -.97 .42 -1.21 -.58  -.54 -.87 .28 .32",
    ],
)
def test_a_quick_search_doubts_paths_long_beside_their_chords(z: str) -> None:
    # A proven local minimum inside the patch, and a shorter way along its edge.
    net = heights(np.array(z.split(), dtype=np.float64).reshape(4, 4))
    straight = bm.solve_geodesic(net, START, END, search="straight")
    assert straight.local_minimum
    quick = bm.solve_geodesic(net, START, END)
    assert quick.length < 0.998 * straight.length
    assert quick.status is bm.Status.ON_BOUNDARY
    thorough = bm.solve_geodesic(net, START, END, search="thorough")
    assert quick.length == pytest.approx(thorough.length, rel=1e-12)
