"""The change of the length of a chain of points with each of them."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints

# The steps of each piece of a curve. The chain's derivative misses that of the curve by the square
# of a step, which two chains cancel; what is left is some 1e-7 of the derivative.
STEPS = 32
# A chain with steps half as long lacks a quarter of what the coarser one lacks.
FINE, COARSE = 4.0 / 3.0, -1.0 / 3.0


class Nodes(NamedTuple):
    """Nodes of a chain.

    Parameters
    ----------
    patch : ndarray of int, shape (n,)
        -1 where the chain stands free.
    parameters : ndarray, shape (n, 2)
    positions : ndarray, shape (n, 3)
    coarse : ndarray of bool, shape (n,)
        Which nodes belong to the chain of double steps, too.
    """

    patch: Ints
    parameters: Array
    positions: Array
    coarse: Bools


def chain_weights(nodes: Nodes) -> Array:
    """Return the derivative of the length of an open curve with each of its nodes, (n, 3)."""
    fine = bends(nodes.positions)
    weights = FINE * fine
    weights[nodes.coarse] += COARSE * bends(nodes.positions[nodes.coarse])
    return np.asarray(weights)


def bends(points: Array) -> Array:
    """Return the unit tangent before each point of an open chain less that after it, (n, 3)."""
    steps = np.diff(points, axis=0)
    sizes = np.linalg.norm(steps, axis=1, keepdims=True)
    steps = np.divide(steps, sizes, out=np.zeros_like(steps), where=sizes > 0.0)
    none = np.zeros((1, 3))
    return np.asarray(np.concatenate([none, steps]) - np.concatenate([steps, none]))
