"""Bezier patches as surfaces that the solver can use."""

from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import bernstein_values, elevate, evaluate
from bodymeasure.geodesic.numerics.array_libraries import constant, namespace, to_numpy
from bodymeasure.geodesic.surfaces.protocol import JET, JET_SIZE, Surface
from bodymeasure.native import MOST_COLUMNS, MOST_DEGREE, bezier_jets, is_compiled


class BezierSurfaces:
    """Bezier patches, each derivative held as control points of the patch's own degree.

    One product of the basis functions with one matrix then gives all derivatives at once, and in a
    numerically stable way. The derivatives are made from the differences of neighboring control
    points, so that they stay accurate however small the patch is and however far from the origin.

    Parameters
    ----------
    control_points : array, shape (problems, m + 1, n + 1, 3)
        An array of any library that keeps to the Python array API standard; the jets are numpy's.
        The last axis may have any number of coordinates.
    """

    def __init__(self, control_points: Any) -> None:
        self.control_points = control_points
        self.coordinates = control_points.shape[-1]
        self.degrees = (control_points.shape[1] - 1, control_points.shape[2] - 1)

    @cached_property
    def nets(self) -> Array:
        """Control points of all derivatives, shape (problems, basis functions, c * derivatives).

        They are made when they are first needed, since they take ten times the memory of the
        patches.
        """
        points = to_numpy(self.control_points)
        problems, size = len(points), (self.degrees[0] + 1) * (self.degrees[1] + 1)
        c = self.coordinates
        nets = np.empty((size, c * len(JET), problems))
        nets[:, :c] = self._positions(points).reshape(problems, size, c).transpose(1, 2, 0)
        along_u, along_v = _edge_maps(*self.degrees)
        for maps, axis, which in ((along_u, 1, _BY_U), (along_v, 2, _BY_V)):
            edges = np.diff(points, axis=axis).reshape(problems, maps.shape[1], c)
            # One large matrix product for all patches.
            columns = edges.transpose(1, 2, 0).reshape(maps.shape[1], c * problems)
            found = (maps @ columns).reshape(len(which), size, c, problems)
            for number, net in zip(which, found, strict=True):
                nets[:, c * number : c * number + c] = net
        return np.ascontiguousarray(nets.transpose(2, 0, 1))

    def _positions(self, points: Array) -> Array:
        """Control points of the positions, moved near the origin, where they have more digits."""
        return np.asarray(points - points.mean(axis=(1, 2), keepdims=True))

    def jet(self, parameters: Array, order: int) -> Array:
        """Return the derivatives in the order of `JET`, shape (derivatives, c, problems, k)."""
        return self._combined(self.nets, self.coordinates * JET_SIZE[order], parameters)

    def positions(self, parameters: Array) -> Array:
        """Return points, shape (problems, k, 3), without preparing any derivatives."""
        return evaluate(to_numpy(self.control_points), parameters)

    def magnitude(self, parameters: Array) -> Array:
        """Return the size of the terms of S_u and S_v, shape (2, problems, k)."""
        columns = slice(self.coordinates, self.coordinates * JET_SIZE[2])
        sizes = np.abs(self.nets[:, :, columns])
        terms = self._combined(sizes, sizes.shape[2], parameters)
        s_u, s_v, s_uu, s_uv, s_vv = np.linalg.norm(terms, axis=1)
        u, v = np.abs(np.moveaxis(parameters, -1, 0))
        return np.stack([s_u + s_uu * u + s_uv * v, s_v + s_uv * u + s_vv * v])

    def _combined(self, nets: Array, columns: int, parameters: Array) -> Array:
        """The first columns of nets at points, shape (columns / c, c, problems, k)."""
        if is_compiled() and max(self.degrees) <= MOST_DEGREE and columns <= MOST_COLUMNS:
            found = bezier_jets(nets, self.degrees, columns, parameters)
            return found.reshape(
                columns // self.coordinates, self.coordinates, *parameters.shape[:2]
            )
        return self._evaluated(nets[:, :, :columns], parameters)

    def _evaluated(self, nets: Array, parameters: Array) -> Array:
        problems, count = parameters.shape[:2]
        basis = np.empty((problems, count, self.degrees[0] + 1, self.degrees[1] + 1))
        in_v = bernstein_values(self.degrees[1], parameters[..., 1])
        for i, value in enumerate(bernstein_values(self.degrees[0], parameters[..., 0])):
            for j, other in enumerate(in_v):
                np.multiply(value, other, out=basis[:, :, i, j])
        values = basis.reshape(problems, count, nets.shape[1]) @ nets
        columns = values.shape[-1]
        return np.ascontiguousarray(values.reshape(-1, columns).T).reshape(
            columns // self.coordinates, self.coordinates, problems, count
        )

    def take(self, problems: Ints) -> "BezierSurfaces":
        """Return the patches of some of the problems."""
        points = self.control_points
        xp = namespace(points)
        part = BezierSurfaces(xp.take(points, constant(problems, points, xp), axis=0))
        if "nets" in self.__dict__:
            part.nets = self.nets[problems]
        return part


def compiled_patches(surface: Surface) -> tuple[Array, tuple[int, int]] | None:
    """Return the nets and degrees of patches as compiled kernels take them; None if none serve."""
    if not isinstance(surface, BezierSurfaces) or surface.coordinates != 3:
        return None
    served = is_compiled() and max(surface.degrees) <= MOST_DEGREE
    return (surface.nets, surface.degrees) if served else None


# The derivatives that are made from differences of control points along u, and along v.
_BY_U = tuple(number for number, (i, _) in enumerate(JET) if i > 0)
_BY_V = tuple(number for number, (i, j) in enumerate(JET) if i == 0 and j > 0)


@lru_cache
def _edge_maps(degree_u: int, degree_v: int) -> tuple[Array, Array]:
    """The matrices from a net's edges along u, and along v, to control points of derivatives.

    The edges are the differences of neighboring control points; the derivatives are those of
    `_BY_U` and `_BY_V`, stacked.
    """
    maps_u, maps_v = _derivative_maps(degree_u), _derivative_maps(degree_v)
    edges_u, edges_v = _maps_of_edges(degree_u), _maps_of_edges(degree_v)
    by_u = [np.kron(edges_u[i - 1], maps_v[j]) for i, j in (JET[number] for number in _BY_U)]
    by_v = [np.kron(maps_u[0], edges_v[j - 1]) for _, j in (JET[number] for number in _BY_V)]
    return np.concatenate(by_u), np.concatenate(by_v)


def _derivative_maps(degree: int) -> list[Array]:
    """The maps from Bezier points of a curve to those of its derivatives, in the same degree."""
    edges = np.diff(np.eye(degree + 1), axis=0)
    return [np.eye(degree + 1)] + [by_edges @ edges for by_edges in _maps_of_edges(degree)]


def _maps_of_edges(degree: int) -> list[Array]:
    """The maps from differences of neighboring Bezier points to the three derivatives."""
    maps = []
    difference = degree * np.eye(degree)
    for order in range(1, 4):
        lower = max(degree - order, 0)
        if order > degree:
            difference = np.zeros((1, degree))
        # Each basis function has a column of control points; all are elevated like one curve's.
        columns = difference.T[:, :, None, None].repeat(3, axis=-1)
        maps.append(elevate(columns, degree, 0)[:, :, 0, 0].T)
        difference = lower * np.diff(difference, axis=0)
    return maps
