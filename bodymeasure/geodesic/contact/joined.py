"""The legs of a path joined into one."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.solving.protocol import EdgeContact
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.spaces.trial_space import TrialSpace


class SolvedLeg(NamedTuple):
    """A leg: values, shape (2, n + 1), at a space's nodes, and its length, a batch of one."""

    space: TrialSpace
    values: Array
    length: Length


@dataclass(frozen=True)
class ContactPath:
    """A path of several legs.

    Parameters
    ----------
    space : TrialSpace
        A piecewise space with one piece for each leg, in proportion to their lengths.
    values : ndarray, shape (2, n + 1)
        The values of u and v at the space's nodes.
    length : Length
        The length, as a batch of one.
    contacts : tuple of EdgeContact
        The edges that the path runs along, in order.
    """

    space: TrialSpace
    values: Array
    length: Length
    contacts: tuple[EdgeContact, ...]


def join(legs: Sequence[SolvedLeg], contacts: tuple[EdgeContact, ...]) -> ContactPath:
    """Join legs into a path, each taking as much of [0, 1] as it has of the length."""
    # An arc that only touches a corner has no length.
    parts = [leg for leg in legs if leg.length.raw[0] > 0.0]
    lengths = np.array([length.raw[0] for _, _, length in parts])
    edges = np.concatenate([[0.0], np.cumsum(lengths) / lengths.sum()])
    edges[-1] = 1.0
    nodes = [np.array([0.0])]
    values = [parts[0].values[:, :1]]
    total = 1 + sum(space.size for space, _, _ in parts)
    degree = max(space.functions.coefficients.shape[1] for space, _, _ in parts)
    coefficients = np.zeros((3, degree, total, len(parts)), dtype=np.longdouble)
    column = 0
    for number, (space, part, _) in enumerate(parts):
        width = edges[number + 1] - edges[number]
        nodes.append(edges[number] + width * space.nodes[1:])
        values.append(part[:, 1:])
        own = space.functions.coefficients[..., 0]
        chain = np.array([1.0, 1.0 / width, 1.0 / width**2])[:, None, None]
        coefficients[:, : own.shape[1], column : column + space.size + 1, number] = own * chain
        column += space.size
    all_nodes = np.concatenate(nodes)
    all_nodes[-1] = 1.0
    joined = TrialSpace(
        nodes=all_nodes,
        condition=max(space.condition for space, _, _ in parts),
        functions=PiecewisePolynomials(edges, coefficients),
        description=" + ".join(space.description for space, _, _ in parts),
    )
    length = Length.of_parts([length for _, _, length in parts])
    return ContactPath(joined, np.concatenate(values, axis=1), length, contacts)
