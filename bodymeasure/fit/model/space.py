"""Shapes of bodies in the A-pose: a mean and its principal components.

`bodymeasure/fit/data/README.md` says where the data come from.
"""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array, Bools, Ints

DATA = Path(__file__).parents[1] / "data"
# The components are stored in steps of so many meters.
STEP = 5e-6


@dataclass(frozen=True, eq=False)
class BodyModel:
    """A space of bodies on one quad mesh, in meters, z up, front = -y, in the A-pose.

    Parameters
    ----------
    mean : ndarray, shape (13380, 3)
        Control vertices of the mean body.
    components : ndarray, shape (120, 13380, 3)
        How one standard deviation of each component moves the vertices; the largest come first.
    sigma : ndarray, shape (120,)
        RMS movement of the surface by one standard deviation.
    vertex_weight : ndarray, shape (13380,)
        Share of each vertex in the surface, in which the components are orthogonal.
    quads : ndarray of int, shape (13378, 4)
    covered : ndarray of bool, shape (13378,)
        Which quads the atlas covers: all but head, hands and feet.
    """

    mean: Array
    components: Array
    sigma: Array
    vertex_weight: Array
    quads: Ints
    covered: Bools


@cache
def body_model() -> BodyModel:
    """The space of bodies, read once."""
    with np.load(DATA / "body_space.npz") as data:
        low, high = data["differences"].astype(np.uint16)
        # 16-bit numbers, in which a sum that leaves the range comes back.
        steps = np.cumsum(low + (high << 8), axis=2, dtype=np.uint16).view(np.int16)
        return BodyModel(
            mean=data["mean"].astype(float),
            components=steps.swapaxes(1, 2).astype(float, order="C") * STEP,
            sigma=data["sigma"].astype(float),
            vertex_weight=data["vertex_weight"].astype(float),
            quads=data["quads"].astype(np.int64),
            covered=data["covered"],
        )


def shaped(coefficients: Array) -> Array:
    """Return the vertices of a body in the A-pose.

    Parameters
    ----------
    coefficients : ndarray, shape (k,)
        In standard deviations, for the first k of the 120 components.

    Returns
    -------
    ndarray, shape (13380, 3)
    """
    model = body_model()
    return model.mean + np.tensordot(coefficients, model.components[: len(coefficients)], 1)


def coefficients_of(vertices: Array, count: int = 120) -> Array:
    """Return the coefficients of the body of the space that is nearest to one in the A-pose.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
    count : int
        How many of the components.

    Returns
    -------
    ndarray, shape (count,)
    """
    model = body_model()
    moved = (vertices - model.mean) * model.vertex_weight[:, None]
    products = np.tensordot(model.components[:count], moved, 2)
    return np.asarray(np.linalg.solve(_gram()[:count, :count], products))


@cache
def _gram() -> Array:
    """Products of the components, which rounding leaves not quite orthogonal; (120, 120)."""
    model = body_model()
    steps = model.components * np.sqrt(model.vertex_weight)[:, None]
    flat = steps.reshape(len(steps), -1)
    return flat @ flat.T
