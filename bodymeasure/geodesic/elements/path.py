"""Paths made of elements: short polynomials, each given by its values at the same nodes."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# The degree of the polynomial on each element. Lengths converge with its double.
DEGREE = 10
# The part of each element's share that is its length; the rest is its way in u and v. Where a path
# hardly moves on the surface, it may move far in u and v.
BY_LENGTH = 0.5
# How far an element leaves the patch between its nodes, in u or v, because of rounding.
OVERSHOOT = 1e-9


@dataclass(frozen=True, eq=False)
class ElementPath:
    """A path on one patch, made of elements that meet at joints.

    Parameters
    ----------
    widths : ndarray, shape (elements,)
        The parts of the path's length that the elements have; their sum is 1.
    values : ndarray, shape (elements, 2, DEGREE + 1)
        u and v at the nodes of each element; the last ones are the first of the next.
    """

    widths: Array
    values: Array

    @property
    def unknowns(self) -> Array:
        """U and v at all nodes, u before v, each joint once; shape (2 nodes,)."""
        first = self.values[:, :, :-1].transpose(0, 2, 1).ravel()
        return np.concatenate([first, self.values[-1, :, -1]])

    @property
    def on_edge(self) -> Bools:
        """The elements that run along an edge of the patch, shape (elements,)."""
        return np.asarray(self.held_throughout.any(axis=1))

    @property
    def held_throughout(self) -> Bools:
        """The coordinates of elements that are those of an edge all along, shape (elements, 2)."""
        on_bound = (self.values == 0.0) | (self.values == 1.0)
        return np.asarray((on_bound & (self.values == self.values[:, :, :1])).all(axis=2))

    @property
    def outside(self) -> Array:
        """How far elements leave the patch between their nodes, in u or v, shape (elements,)."""
        between = polynomial_space(DEGREE).between_nodes @ self.values.transpose(0, 2, 1)
        return np.asarray(np.maximum(np.abs(between - 0.5).max(axis=(1, 2)) - 0.5, 0.0))

    @property
    def overshoots(self) -> Bools:
        """The elements that leave the patch by more than rounding, shape (elements,)."""
        return np.asarray(self.outside > OVERSHOOT)

    def by_element(self, nodes: NDArray[Any]) -> NDArray[Any]:
        """Return unknowns, or what belongs to them, as shape (elements, 2, DEGREE + 1)."""
        rows = np.arange(len(self.widths))[:, None] * DEGREE + np.arange(DEGREE + 1)
        return np.ascontiguousarray(nodes.reshape(-1, 2)[rows].transpose(0, 2, 1))

    def moved(self, unknowns: Array) -> "ElementPath":
        """Return the path with other unknowns."""
        return ElementPath(self.widths, self.by_element(unknowns))

    def weighted(self, lengths: Array) -> "ElementPath":
        """Return the same path with the shares that its elements' lengths say."""
        return ElementPath(lengths / lengths.sum(), self.values)

    def split(self, places: list[list[float]]) -> "ElementPath":
        """Return the same path with elements cut in parts.

        Parameters
        ----------
        places : list of list of float
            For each element where it is cut: increasing parameters between 0 and 1.
        """
        space = polynomial_space(DEGREE)
        widths, values = [], []
        for width, element, cuts in zip(self.widths, self.values, places, strict=True):
            edges = np.array([0.0, *cuts, 1.0])
            parts = np.diff(edges)
            for first, part in zip(edges, parts, strict=False):
                if part == 1.0:
                    values.append(element)
                else:
                    maps = space.functions.values(first + part * space.nodes)
                    values.append(_kept_on_bounds(element, element @ maps.T))
                widths.append(width * part)
        result = np.stack(values)
        # Joints are the same number on both sides, and the ends stay what they are.
        result[1:, :, 0] = result[:-1, :, -1]
        result[0, :, 0], result[-1, :, -1] = self.values[0, :, 0], self.values[-1, :, -1]
        return ElementPath(np.array(widths), np.clip(result, 0.0, 1.0))


def _kept_on_bounds(element: Array, values: Array) -> Array:
    """Values between the nodes; a coordinate that is one number at all nodes stays that."""
    constant = (element == element[:, :1]).all(axis=1)
    return np.where(constant[:, None], element[:, :1], values)


def from_polygon(surface: Surface, polygon: Array, elements: int) -> ElementPath:
    """Return a path along a polygon.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    polygon : ndarray, shape (m + 1, 2)
    elements : int
        The number of elements.
    """
    steps = np.diff(surface.jet(polygon[None], 0)[0, :, 0], axis=1)
    long = np.sqrt((steps * steps).sum(axis=0))
    far = np.abs(np.diff(polygon, axis=0)).sum(axis=1)
    long, far = long / long.sum(), far / far.sum()
    # No edge is of no length at all, so that every vertex has a time of its own.
    along = np.concatenate([[0.0], np.cumsum(long + 1e-12 * far)])
    along /= along[-1]
    share = np.concatenate([[0.0], np.cumsum(BY_LENGTH * long + (1.0 - BY_LENGTH) * far)])
    wanted = np.linspace(0.0, share[-1], elements + 1)[1:-1]
    edges = np.array([0.0, *np.interp(wanted, share, along), 1.0])
    widths = np.diff(edges)
    nodes = polynomial_space(DEGREE).nodes
    times = edges[:-1, None] + widths[:, None] * nodes
    values = np.stack([np.interp(times, along, polygon[:, axis]) for axis in (0, 1)], axis=1)
    values[1:, :, 0] = values[:-1, :, -1]
    values[0, :, 0], values[-1, :, -1] = polygon[0], polygon[-1]
    return ElementPath(widths, values)
