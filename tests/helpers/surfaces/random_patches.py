"""Random patches as rough as the paper's, made without the generator that is tested."""

import numpy as np

from bodymeasure._typing import Array


def wild_patches(
    rng: np.random.Generator,
    count: int,
    side: float = 0.6,
    *,
    jitter: float = 0.0,
    symmetric: bool = False,
) -> Array:
    """Control points over a regular grid, displaced at random, with heights on six levels."""
    height = rng.integers(0, 6, (count, 4, 4)) / 5.0
    if symmetric:
        height = np.triu(height) + np.triu(height, 1).swapaxes(1, 2)
    height[:, 0, 0], height[:, 3, 3] = 0.0, 1.0
    x, y = np.meshgrid(np.arange(4) * side / 3, np.arange(4) * side / 3, indexing="ij")
    base = np.broadcast_to(np.stack([x, y], axis=-1), (count, 4, 4, 2))
    base = base + jitter * rng.uniform(-1.0, 1.0, base.shape)
    return np.concatenate([base, height[..., None]], axis=-1)
