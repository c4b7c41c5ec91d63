"""A string drawn taut over the skin: nodes, springs between them, and which nodes touch."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.taut.equilibrium import Walls, equilibrium, walls_of, with_ridges
from bodymeasure.taut.ridges import Pins, ridge_feet
from bodymeasure.taut.skin import Feet, Skin

# The most rounds of feet and springs. It takes 4 to 8, or more if the string slides sideways.
MAX_ROUNDS = 40
# A string whose length may change by less than this part of it is at rest.
REST = 1e-10
# Over sharp kinks two nodes may alternate between two places. After so many rounds steps are
# halved, and a string counts as at rest if its length may change by this part, which counts as its
# error.
PATIENCE = 8
LATE_REST = 3e-8
# A node moves by at most this part of the length in one round, so that it does not jump through a
# limb.
LONGEST_STEP = 0.06
# The patch beyond a valley's seam is a node's second wall if the seam is within reach of the node's
# foot. The reach is this multiple of the node's last step, between two parts of the length; it
# shrinks with the steps, since far from the seam the wall is only rough.
FIRST_REACH, LEAST_REACH, REACH_STEPS = 0.02, 1e-8, 2.0
# Nodes that start closer to the skin than this part of the length are taken to touch it.
ON_SKIN = 1e-8


class String(NamedTuple):
    """A string at rest, or as near to it as the rounds led.

    Parameters
    ----------
    nodes : ndarray, shape (n + 1, 3)
        Its ends are fixed.
    weights : ndarray, shape (n,)
        Rest lengths of the springs, up to a factor: at rest, segments are proportional to them.
    feet : Feet
        The feet of the n - 1 inner nodes.
    touching : ndarray of bool, shape (n - 1,)
        Which inner nodes press on the skin.
    pressure : ndarray, shape (n - 1,)
        The force with which they press; 0 where they do not.
    pins : Pins
        The ridges that inner nodes are held on.
    error : float
        The amount by which the length may still change, in its unit.
    settled : bool
    """

    nodes: Array
    weights: Array
    feet: Feet
    touching: Bools
    pressure: Array
    pins: Pins
    error: float
    settled: bool

    def near(self, node: Ints) -> Feet:
        """Return feet of inner nodes that are those numbered (k,), or next to them."""
        return self.feet.rows(np.clip(node - 1, 0, len(self.pressure) - 1))


def polygon_length(nodes: Array) -> float:
    """Return the sum of the lengths of the segments."""
    return float(np.linalg.norm(np.diff(nodes, axis=0), axis=1).sum())


def relax(
    skin: Skin,
    nodes: Array,
    weights: Array,
    pins: Pins,
    pressure: Array | None = None,
    feet: Feet | None = None,
) -> String:
    """Let a string slide to rest outside the skin.

    Parameters
    ----------
    skin : Skin
    nodes : ndarray, shape (n + 1, 3)
    weights : ndarray, shape (n,)
    pins : Pins
        The ridges that inner nodes start on.
    pressure : ndarray, shape (n - 1,), optional
        A guess of the forces on the inner nodes that touch; 0 for the others. Without one, those
        that start on the skin are taken to touch.
    feet : Feet, optional
        The feet of the inner nodes, if they are known.

    Notes
    -----
    Half the sum of squared segments over weights is minimized. Each inner node is kept on the outer
    side of the tangent plane at its foot, and in the valley between two patches, of both planes.
    The quadratic problem of each round is solved by a primal-dual active set (M. Hintermueller,
    K. Ito and K. Kunisch, SIAM J. Optim. 13 (2002) 865-888). The bend of the skin under pressure
    enters the matrix, as Newton's method asks, where that stays positive definite.
    """
    nodes = nodes.copy()
    length = polygon_length(nodes)
    reach = np.full(len(nodes) - 2, FIRST_REACH * length)
    if feet is None or pins.there.any():
        feet, walls, pins = _obstacles(skin, nodes, pins, reach)
    else:
        walls = walls_of(skin, nodes[1:-1], feet, reach)
    load, held = np.zeros((len(nodes) - 2, 2)), np.zeros((len(nodes) - 2, 2), dtype=np.bool_)
    if pressure is None:
        held[:, 0] = feet.gap <= ON_SKIN * length
    else:
        load[:, 0], held[:, 0] = pressure, pressure > 0.0
    held[pins.there] = True
    error = np.inf
    for number in range(MAX_ROUNDS):
        step, load, held = equilibrium(nodes, weights, walls, load, held)
        pins = pins.kept(np.asarray(held.all(axis=1)))
        if number >= PATIENCE:
            step *= 0.5
        error = _rest_error(step, weights, load, feet.gap) * float(weights.sum()) / length
        if error <= (REST if number < PATIENCE else LATE_REST) * length:
            break
        moved = np.linalg.norm(step, axis=1)
        step *= min(1.0, LONGEST_STEP * length / max(float(moved.max()), LONGEST_STEP * length))
        nodes[1:-1] += step
        reach = np.clip(REACH_STEPS * moved, LEAST_REACH * length, FIRST_REACH * length)
        feet, walls, pins = _obstacles(skin, nodes, pins, reach, feet)
        if pressure is not None:
            _put_on_skin(skin, nodes[1:-1], feet, walls, held)
        length = polygon_length(nodes)
    touching = np.asarray(held.any(axis=1))
    settled = error <= LATE_REST * length
    return String(nodes, weights, feet, touching, load.sum(axis=1), pins, error, settled)


def _obstacles(
    skin: Skin, nodes: Array, pins: Pins, reach: Array, near: Feet | None = None
) -> tuple[Feet, Walls, Pins]:
    """Return feet and walls of the inner nodes; pinned ones move to their ridge, in place."""
    if not pins.there.any():
        feet = skin.feet(nodes[1:-1], near)
        return feet, walls_of(skin, nodes[1:-1], feet, reach), pins
    ridges = ridge_feet(skin, nodes[1:-1], pins)
    nodes[1 + ridges.row] = ridges.first.position
    feet = skin.feet(nodes[1:-1], near)
    walls = with_ridges(walls_of(skin, nodes[1:-1], feet, reach), ridges)
    return feet, walls, ridges.pins


def _put_on_skin(skin: Skin, positions: Array, feet: Feet, walls: Walls, held: Bools) -> None:
    """Move nodes that one wall holds to their feet, in place, where that is straight down it.

    That is for strings that are nearly at rest. One that is far from it may be held for a while on
    the wrong side of a limb, where it would then stay.
    """
    down = positions - feet.gap[:, None] * feet.normal
    off = np.linalg.norm(down - feet.position, axis=1)
    row = np.flatnonzero(held[:, 0] & ~held[:, 1] & (off <= skin.touching))
    positions[row] = feet.position[row]
    feet.gap[row] = feet.depth[row] = walls.gap[row, 0] = 0.0


def _rest_error(step: Array, weights: Array, load: Array, gap: Array) -> float:
    """Return the energy of the next step, and of bringing nodes to the skin from off or inside it.

    Divided by the tension, it is a length: energy is length squared over twice the sum of weights.
    """
    padded = np.concatenate([np.zeros((1, 3)), step, np.zeros((1, 3))])
    stretch = 0.5 * float(((np.diff(padded, axis=0) ** 2).sum(axis=1) / weights).sum())
    pressing = load.sum(axis=1)
    pressed = float((pressing * np.abs(gap)).sum())
    # A node inside the skin that nothing holds would be pressed like the others.
    loose = (pressing == 0.0) & (gap < 0.0)
    return stretch + pressed - float(pressing.max(initial=0.0) * gap[loose].sum())
