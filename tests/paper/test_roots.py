import numpy as np
import pytest
from helpers.oracles.root_multistart import (
    distinct,
    expansion,
    missed,
    multistart_roots,
    sharpened,
    starts,
)
from helpers.surfaces.random_patches import wild_patches

from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.paper.method.polynomial_pair import PolynomialPair
from bodymeasure.paper.method.roots import all_roots, counted, real_roots
from bodymeasure.paper.method.system_roots import GENERAL_COUNT, GRAPH_COUNT, system_roots
from bodymeasure.paper.method.two_functions import (
    MIDDLE,
    collocation_equations,
    graph_directions,
    graph_equations,
    paper_space,
)


def test_all_intersections_of_lines_are_found() -> None:
    # (x - 1)(x + 2)(y - x) and (y - 3)(x + y) share eight points, one of which is at infinity.
    first = np.zeros((1, 4, 2))
    first[0, :, 1] = [-2.0, 1.0, 1.0, 0.0]
    first[0, 1:, 0] -= first[0, :3, 1]
    second = np.zeros((1, 2, 3))
    second[0, 1, :2] = [-3.0, 1.0]
    second[0, 0, 1:] = [-3.0, 1.0]
    roots = all_roots(PolynomialPair(first, second), (1.0,))
    expected = [(-2.0, 2.0), (-2.0, 3.0), (0.0, 0.0), (1.0, -1.0), (1.0, 3.0), (3.0, 3.0)]
    np.testing.assert_allclose(real_roots(roots[0]), expected, atol=1e-10)
    assert counted(roots)[0] == 6


def test_complex_roots_are_counted_and_left_out() -> None:
    # x^2 + 1 = 0, y = x
    first, second = np.array([[[1.0], [0.0], [1.0]]]), np.array([[[0.0, 1.0], [-1.0, 0.0]]])
    roots = all_roots(PolynomialPair(first, second), (1.0,))
    assert counted(roots)[0] == 2
    assert len(real_roots(roots[0])) == 0


@pytest.mark.parametrize("jitter", [0.0, 0.05])
def test_the_polynomials_are_the_solvers_equations(jitter: float, rng: np.random.Generator) -> None:
    space, nets = paper_space((0.45,)), wild_patches(rng, 6, jitter=jitter)
    pair = collocation_equations(nets, space)
    ratios = []
    for _ in range(3):
        places = rng.uniform(-1.0, 2.0, (6, 2))
        values = np.zeros((6, 2, 3))
        values[:, :, 1], values[:, :, 2] = places, 1.0
        residual, _ = residual_and_jacobian(BezierSurfaces(nets), space, values)
        found = pair.at((places - MIDDLE)[:, None].astype(np.complex128)).value
        ratios.append(np.stack([f[:, 0].real for f in found], axis=1) / residual[:, :, 0])
    np.testing.assert_allclose(ratios[1:], [ratios[0]] * 2, rtol=1e-8)


def test_a_trial_space_moves_as_its_functions_do() -> None:
    motion = paper_space().differentiation[:, 0, 1:]
    np.testing.assert_allclose(motion, expansion(0.5)[1:], rtol=0.0, atol=1e-13)


def test_graphs_are_told_from_other_patches(rng: np.random.Generator) -> None:
    graphs = wild_patches(rng, 4)
    turned = graphs @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
    assert graph_directions(graphs)[1].all()
    assert graph_directions(turned + 5.0)[1].all()
    assert not graph_directions(wild_patches(rng, 4, jitter=1e-3))[1].any()


def test_the_equations_of_a_graph_have_the_roots_of_the_systems(rng: np.random.Generator) -> None:
    space, nets = paper_space(), wild_patches(rng, 5)
    direction, _ = graph_directions(nets)
    pair = graph_equations(nets, space, direction)
    for number, roots in enumerate(system_roots(nets, space).real):
        here = pair.take(np.array([number])).at((roots - MIDDLE)[None].astype(np.complex128))
        for value, size in zip(here.value, here.size, strict=True):
            assert (np.abs(value) < 1e-10 * size).all()


def test_a_plane_has_one_solution() -> None:
    u, v = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    plane = np.stack([u, 2.0 * v, u + v], axis=-1)[None]
    (roots,) = system_roots(plane, paper_space()).real
    # u'' = 0 at t = 1/2.
    slope_by_place, slope_by_end = paper_space().differentiation[1, 0, 1:]
    np.testing.assert_allclose(roots, [[-slope_by_end / slope_by_place] * 2], rtol=1e-12)


def test_exchanging_u_and_v_exchanges_the_roots(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 5, jitter=0.02)
    there = system_roots(nets, paper_space()).real
    for roots, turned in zip(
        there, system_roots(nets.swapaxes(1, 2), paper_space()).real, strict=True
    ):
        assert len(roots) == len(turned)
        assert not missed(turned[:, ::-1], roots)


def test_a_batch_gives_what_single_patches_give(rng: np.random.Generator) -> None:
    nets = np.concatenate([wild_patches(rng, 3), wild_patches(rng, 3, jitter=0.02)])
    together = system_roots(nets, paper_space()).real
    for net, roots in zip(nets, together, strict=True):
        (alone,) = system_roots(net[None], paper_space()).real
        np.testing.assert_allclose(alone, roots, rtol=1e-9)


def test_general_patches_have_the_general_number_of_roots(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 20, jitter=0.05)
    assert (system_roots(nets, paper_space()).complex_count == GENERAL_COUNT).all()
    graphs = wild_patches(rng, 20)
    graphs[..., 2] = rng.random((20, 4, 4))
    assert (system_roots(graphs, paper_space()).complex_count == GRAPH_COUNT).all()


def test_roots_are_roots_in_exact_arithmetic(rng: np.random.Generator) -> None:
    motion = paper_space().differentiation[:, 0, 1:]
    nets = np.concatenate([wild_patches(rng, 2), wild_patches(rng, 1, jitter=0.02)])
    for net, roots in zip(nets, system_roots(nets, paper_space()).real, strict=True):
        assert len(roots)
        np.testing.assert_allclose(sharpened(net, motion, roots), roots, rtol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("side", "jitter", "symmetric"),
    [(0.6, 0.0, False), (1.0, 0.0, False), (0.6, 0.045, False), (0.6, 0.0, True)],
)
def test_no_root_of_a_dense_multistart_is_missed(
    side: float, jitter: float, symmetric: bool, rng: np.random.Generator
) -> None:
    space = paper_space()
    motion = space.differentiation[:, 0, 1:]
    guesses = starts(rng)
    assert len(guesses) >= 2000
    nets = wild_patches(rng, 50, side, jitter=jitter, symmetric=symmetric)
    total = 0
    for net, roots in zip(nets, system_roots(nets, space).real, strict=True):
        found = multistart_roots(net, motion, guesses)
        total += len(found)
        # A further root that Newton's method finds must be one in exact arithmetic.
        others = np.array(missed(roots, found)).reshape(-1, 2)
        exact = sharpened(net, motion, others)
        assert not missed(roots, distinct(exact[np.isfinite(exact).all(axis=1)]))
    assert total > 5 * len(nets)
