"""Polygons that descend to rest in the box, and leave saddles."""

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.geodesic.shortest.descent import box_steps, descend
from bodymeasure.geodesic.shortest.polygon_energy import polygon_energy, polygon_lengths
from bodymeasure.geodesic.shortest.saddles import descent_directions
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

START, END = np.zeros(2), np.ones(2)


def heights(z: Array) -> BezierSurfaces:
    """Patches over the unit square with heights (patches, 4, 4)."""
    line = np.linspace(0.0, 1.0, 4)
    x, y = np.broadcast_arrays(line[:, None], line, subok=False)
    return BezierSurfaces(np.stack([np.broadcast_to(each, z.shape) for each in (x, y, z)], axis=-1))


def ridge() -> BezierSurfaces:
    """A hump that is symmetric about the diagonal, which leads over its top."""
    z = np.zeros((1, 4, 4))
    z[:, 1:3, 1:3] = 2.0
    return heights(z)


def lines(count: int) -> Array:
    return np.repeat(np.linspace(START, END, 33)[None], count, axis=0)


def test_derivatives_of_the_energy(rng: np.random.Generator) -> None:
    surface = heights(rng.random((1, 4, 4)))
    points = lines(1)[:, ::8] + 0.05 * rng.standard_normal((1, 5, 2))
    here = polygon_energy(surface, points)
    positions = surface.jet(points, 0)[0, :, 0]
    edges = np.diff(positions, axis=1)
    assert here.energy[0] == pytest.approx(4.0 * (edges**2).sum(), rel=1e-14)
    diagonal = here.metric + here.bending
    step = 1e-6
    for axis in (0, 1):
        for k in range(3):
            moved = [points.copy(), points.copy()]
            for sign, each in zip((-1.0, 1.0), moved, strict=True):
                each[0, k + 1, axis] += sign * step
            less, more = (polygon_energy(surface, each) for each in moved)
            slope = (more.energy - less.energy) / (2.0 * step)
            assert here.gradient[axis, k] == pytest.approx(slope, abs=1e-7)
            bend = (more.gradient - less.gradient)[..., 0] / (2.0 * step)
            assert diagonal[:, axis, k, 0] == pytest.approx(bend[:, k], abs=1e-6)
            if k < 2:
                assert here.lower[:, axis, k, 0] == pytest.approx(bend[:, k + 1], abs=1e-6)


def test_descent_never_lengthens_and_stays_in_the_box(rng: np.random.Generator) -> None:
    surface = heights(rng.random((20, 4, 4)))
    seeds = rng.random((20, 17, 2))
    seeds[:, 0], seeds[:, -1] = START, END
    points = descend(surface, seeds)
    assert ((points >= 0.0) & (points <= 1.0)).all()
    assert (points[:, 0] == START).all()
    assert (points[:, -1] == END).all()
    lengths = polygon_lengths(surface, points)
    assert (lengths < polygon_lengths(surface, seeds)).all()
    again = polygon_lengths(surface, descend(surface, points))
    assert again == pytest.approx(lengths, rel=1e-9)
    ends = surface.jet(lines(20)[:, [0, -1]], 0)[0]
    chord = np.linalg.norm(ends[..., 1] - ends[..., 0], axis=0)
    assert (lengths >= chord).all()


def test_at_rest_no_neighboring_polygon_is_shorter(rng: np.random.Generator) -> None:
    surface = heights(rng.random((10, 4, 4)))
    points = descend(surface, lines(10))
    energy = polygon_energy(surface, points).energy
    for _ in range(20):
        moved = points.copy()
        moved[:, 1:-1] += 1e-3 * rng.standard_normal((10, 31, 2))
        assert (polygon_energy(surface, np.clip(moved, 0.0, 1.0)).energy > energy).all()


def test_problems_do_not_mind_their_neighbors(rng: np.random.Generator) -> None:
    surface = heights(2.0 * rng.random((10, 4, 4)))
    together = descend(surface, lines(10))
    for i in range(10):
        alone = descend(surface.take(np.array([i])), lines(1))
        # Where the energy is flat rounding errors grow, to far less than rest is defined by.
        assert alone[0] == pytest.approx(together[i], abs=1e-7)


def test_a_saddle_is_known_and_left_across_the_ridge() -> None:
    over = descend(ridge(), lines(1))
    assert over[0, :, 0] == pytest.approx(over[0, :, 1], abs=1e-4)
    saddles, direction = descent_directions(ridge(), over)
    assert saddles.tolist() == [0]
    assert np.abs(direction).max() == pytest.approx(1.0)
    # The direction off the ridge is to the side: u one way, v the other.
    assert direction[0, 16, 0] == pytest.approx(-direction[0, 16, 1], rel=1e-3)
    top = polygon_lengths(ridge(), over)
    for sign in (-1.0, 1.0):
        beside = descend(ridge(), over + 0.05 * sign * direction)
        assert polygon_lengths(ridge(), beside) < 0.95 * top
        assert len(descent_directions(ridge(), beside)[0]) == 0


def test_a_minimum_is_no_saddle(rng: np.random.Generator) -> None:
    flat = heights(np.zeros((3, 4, 4)))
    saddles, direction = descent_directions(flat, descend(flat, lines(3)))
    assert len(saddles) == 0
    assert direction.shape == (0, 33, 2)
    # The edge u = 0 holds it against a pull outwards: it is at rest, even if the Hessian is
    # indefinite.
    mild = heights(0.3 * rng.random((10, 4, 4)))
    along_edge = lines(10) * (0.0, 1.0)
    assert len(descent_directions(mild, descend(mild, along_edge))[0]) == 0


def test_a_step_is_to_the_minimum_of_the_model_in_the_box(rng: np.random.Generator) -> None:
    # Quadratic programs that are convex for their damping: the conditions of Karush, Kuhn and
    # Tucker say of each coordinate which it is.
    surface = heights(rng.random((20, 4, 4)))
    points = np.clip(lines(20) + 0.4 * rng.standard_normal((20, 33, 2)), 0.0, 1.0)
    here, inner = polygon_energy(surface, points), points[:, 1:-1].transpose(2, 1, 0)
    step, decrease = box_steps(here, inner, np.full(20, 3.0))
    assert np.isfinite(decrease).all()
    there = inner + step
    assert ((there >= -1e-14) & (there <= 1.0 + 1e-14)).all()
    slope = here.gradient + np.einsum("abkp,bkp->akp", here.bending + 4.0 * here.metric, step)
    slope[:, 1:] += np.einsum("abkp,bkp->akp", here.lower, step[:, :-1])
    slope[:, :-1] += np.einsum("bakp,bkp->akp", here.lower, step[:, 1:])
    low, high = there <= 1e-14, there >= 1.0 - 1e-14
    assert low.any()
    assert high.any()
    size = np.abs(here.gradient).max()
    assert (slope[low] > -1e-12 * size).all()
    assert (slope[high] < 1e-12 * size).all()
    assert np.abs(slope[~low & ~high]).max() < 1e-12 * size
    expected = -0.5 * ((here.gradient + slope) * step).sum(axis=(0, 1))
    assert decrease == pytest.approx(expected, rel=1e-10)


def test_no_polygon_takes_no_time_to_rest() -> None:
    assert descend(ridge().take(np.array([], np.int64)), lines(0)).shape == lines(0).shape
