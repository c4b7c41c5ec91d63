"""Sections by planes through poles, the sides of patches that are collapsed to a point."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import EdgeTable
from bodymeasure.section.crossings import Crossings
from bodymeasure.section.plane import Plane

# Poles within this part of the atlas's size from the plane lie in it: a plane through a pole is
# given by rounded numbers. The plane is put on them.
IN_PLANE = 1e-11


class PolesInPlane(NamedTuple):
    """The collapsed sides that lie in a plane.

    Parameters
    ----------
    sides : ndarray of bool, shape (patches, 4)
    points : ndarray, shape (k, 3)
        The poles.
    away : float
        The largest distance of one of them from the plane.
    """

    sides: Bools
    points: Array
    away: float


def poles_in(points: Array, table: EdgeTable, plane: Plane, size: float) -> PolesInPlane:
    """Return the collapsed sides that lie in a plane.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
        Control points of the atlas.
    table : EdgeTable
    plane : Plane
    size : float
        Size of the atlas.
    """
    sides = table.collapsed
    if not sides.any():
        return PolesInPlane(sides, points[:0], 0.0)
    distance = np.abs(plane.distances(points))[table.control_index[:, :, 0]]
    sides &= distance <= IN_PLANE * size
    number = np.unique(table.control_index[sides][:, 0])
    return PolesInPlane(sides, points[number], float(distance[sides].max(initial=0.0)))


def turned_about(plane: Plane, points: Array, angle: float) -> Plane:
    """Return a plane that contains one point or two, turned about them by a small angle."""
    first, second = plane.frame()
    through = Plane(points[0], plane.normal)
    axis = first + 0.7 * second
    if len(points) > 1:
        axis = points[np.argmax(np.linalg.norm(points - points[0], axis=1))] - points[0]
        # The plane is put on both points.
        normal = plane.normal - (plane.normal @ axis) / (axis @ axis) * axis
        through = Plane(points[0], normal)
    aside = np.cross(axis / np.linalg.norm(axis), through.normal)
    return replace(through, normal=through.normal + angle * aside)


def opened(table: EdgeTable, sides: Bools) -> tuple[EdgeTable, Ints]:
    """Return the table with an edge for each collapsed side that lies in the plane.

    The pole of each edge is returned, too: the number of its control point, -1 for other edges.
    """
    count, more = len(table.sides), int(sides.sum())
    if not more:
        return table, np.full(count, -1)
    edge, is_reversed = table.edge.copy(), table.reversed.copy()
    edge[sides] = count + np.arange(more)
    is_reversed[sides] = False
    number = np.append(table.sides, np.ones(more, dtype=np.int64))
    pole = np.append(np.full(count, -1), table.control_index[sides][:, 0])
    return EdgeTable(table.control_index, edge, is_reversed, number), pole


def joined_at_poles(crossings: Crossings, pole: Ints) -> Crossings:
    """Return crossings of which two that lie in one pole are one, through which the curve goes on.

    Parameters
    ----------
    crossings : Crossings
    pole : ndarray of int, shape (edges,)
        As `opened` returns it.
    """
    on_edge = crossings.line < len(pole)
    at = np.where(on_edge, pole[np.where(on_edge, crossings.line, 0)], -1)
    number, sides = crossings.number.copy(), crossings.sides.copy()
    for one in np.unique(at[at >= 0]).tolist():
        here = np.flatnonzero(at == one)
        here = here[np.isin(here, number)]
        for first, second in zip(here[::2].tolist(), here[1::2].tolist(), strict=False):
            number[number == second] = first
            sides[first] = 2
    return crossings._replace(number=number, sides=sides)
