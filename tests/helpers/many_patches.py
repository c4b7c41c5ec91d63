"""Surfaces of many patches on which paths cross seams: bodies, quadrics, a torus, random ones."""

from collections.abc import Callable
from functools import cache, partial

import numpy as np
from helpers.surfaces.quad_grids import spline_atlas
from helpers.surfaces.quadrics import joined, sphere_nets, stretched, torus_nets

import bodymeasure as bm
from bodymeasure.atlas import Atlas

# Quads along a side of a random surface's grid, with one more around, and its heights.
QUADS, HEIGHT = 6, 0.8
THREE_BODIES = ("female_average", "female_heavy", "male_average")


@cache
def torus() -> Atlas:
    return joined(torus_nets(2.0, 0.7))


@cache
def sphere() -> Atlas:
    return joined(sphere_nets())


@cache
def ellipsoid() -> Atlas:
    return joined(stretched(sphere_nets(), (1.0, 0.7, 0.4)))


@cache
def random_surface(seed: int) -> Atlas:
    """A smooth surface of 16 patches over a grid, with random heights and places."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(QUADS + 1.0), np.arange(QUADS + 1.0), indexing="ij")
    points = np.stack([x, y, HEIGHT * rng.standard_normal(x.shape)], axis=-1)
    points[..., :2] += rng.uniform(-0.2, 0.2, (*x.shape, 2))
    return spline_atlas(points, 1)


SURFACES: dict[str, Callable[[], Atlas]] = {
    **{name: partial(bm.load_sample, name) for name in THREE_BODIES},
    "torus": torus,
    "sphere": sphere,
    "ellipsoid": ellipsoid,
    **{f"random {seed}": partial(random_surface, seed) for seed in (1, 2, 3)},
}
