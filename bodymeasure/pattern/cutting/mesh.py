"""A mesh of a body that curves do not cross: patches cut along them, and welded by their edges."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import EDGES, Atlas, edge_table
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.curves.skin_curve import Run, SkinCurve
from bodymeasure.pattern.cutting.patch import cut_patch
from bodymeasure.pattern.cutting.sides import SAME, SidePoints
from bodymeasure.pattern.grid import cell_triangles, regular_grid
from bodymeasure.pattern.planar import shapely

# A side of a triangle this near to a curve, in (u, v), is a part of it. Curves are straight between
# their points, so that what is farther is not rounding.
ON_CURVE = 1e-9
# Digits of parameters by which vertices inside patches are told apart.
DIGITS = 10


@dataclass(frozen=True, eq=False)
class CutMesh:
    """A mesh of all patches of a body.

    Parameters
    ----------
    patch : ndarray of int, shape (k,)
        The patch of each triangle.
    parameters : ndarray, shape (k, 3, 2)
        (u, v) of its corners on that patch.
    vertex : ndarray of int, shape (k, 3)
        The numbers of its corners, which neighbors share.
    curve : ndarray of int, shape (k, 3)
        The number of the curve along which each side runs, from one corner to the next; -1 if it is
        inside.
    """

    patch: Ints
    parameters: Array
    vertex: Ints
    curve: Ints

    def positions(self, cloth: Cloth, kept: Bools) -> Array:
        """Return the positions on the cloth of the corners of some triangles, shape (k, 3, 3)."""
        patch = np.repeat(self.patch[kept], 3)
        return cloth.positions(patch, self.parameters[kept].reshape(-1, 2)).reshape(-1, 3, 3)


def cut_mesh(atlas: Atlas, curves: list[SkinCurve]) -> CutMesh:
    """Cut the mesh of a body along curves.

    Parameters
    ----------
    atlas : Atlas
    curves : list of SkinCurve
    """
    table, grid = edge_table(atlas.index), regular_grid(atlas)
    points = SidePoints(table, (run for curve in curves for run in curve.runs))
    chains: dict[int, list[tuple[int, Array]]] = {}
    for number, curve in enumerate(curves):
        before = Run(-1, np.zeros((1, 2)))
        for run in curve.runs:
            snapped = points.snapped(run)
            meet = before.patch == run.patch
            if meet and np.abs(before.parameters[-1] - snapped[0]).max() < SAME:
                # Joints within a patch are found twice, to rounding.
                snapped[0] = before.parameters[-1]
            before = Run(run.patch, snapped)
            moved = np.concatenate([[True], np.abs(np.diff(snapped, axis=0)).max(axis=1) > 0.0])
            if moved.sum() > 1:
                chains.setdefault(run.patch, []).append((number, snapped[moved]))
    cut = [patch for patch in range(len(atlas)) if patch in chains or points.is_cut(patch)]
    whole = np.setdiff1d(np.arange(len(atlas)), cut)
    places, parameters = cell_triangles()
    count = len(places)
    patches = [np.repeat(whole, count)]
    corners = [np.tile(parameters, (len(whole), 1, 1))]
    vertices = [grid.vertex[whole][:, places[..., 0], places[..., 1]].reshape(-1, 3)]
    on_curve = [np.full((len(whole) * count, 3), -1, dtype=np.int64)]
    naming = _Naming(points, grid.vertex, grid.count)
    for patch in cut:
        here = chains.get(patch, [])
        sides = [points.of(patch, side)[0] for side in range(4)]
        triangles = cut_patch([chain for _, chain in here], sides)
        patches.append(np.full(len(triangles), patch, dtype=np.int64))
        corners.append(triangles)
        vertices.append(naming.numbers(patch, triangles.reshape(-1, 2)).reshape(-1, 3))
        on_curve.append(_curves_of(triangles, here))
    vertex = np.concatenate(vertices)
    # Triangles at a collapsed side have two corners in one.
    kept = (vertex != np.roll(vertex, 1, axis=1)).all(axis=1)
    mesh = CutMesh(
        np.concatenate(patches)[kept],
        np.concatenate(corners)[kept],
        vertex[kept],
        np.concatenate(on_curve)[kept],
    )
    return _with_both_sides(mesh)


class _Naming:
    """Numbers of vertices by their places, the same from both patches of a seam."""

    def __init__(self, points: SidePoints, regular: Ints, count: int) -> None:
        self.points, self.regular, self.count = points, regular, count
        self.known: dict[tuple[int, ...], int] = {}

    def numbers(self, patch: int, parameters: Array) -> Ints:
        cells = self.regular.shape[1] - 1
        nearest = np.rint(parameters * cells)
        is_regular = (np.abs(parameters - nearest / cells) < 0.1 * SAME).all(axis=1)
        places = nearest.astype(np.int64)
        result = self.regular[patch, places[:, 0], places[:, 1]].copy()
        for row in np.flatnonzero(~is_regular).tolist():
            result[row] = self._number(patch, parameters[row])
        return np.asarray(result)

    def _number(self, patch: int, place: Array) -> int:
        key: tuple[int, ...] = (-1, patch, *(round(float(x) * 10**DIGITS) for x in place))
        for number, side in enumerate(EDGES):
            if place[side.fixed_axis] == side.fixed_value:
                if self.points.table.collapsed[patch, number]:
                    fixed = -1 if side.fixed_value else 0
                    return int(
                        self.regular[
                            (patch, fixed, 0) if side.fixed_axis == 0 else (patch, 0, fixed)
                        ]
                    )
                own, of_edge = self.points.of(patch, number)
                at = int(np.abs(own - place[1 - side.fixed_axis]).argmin())
                along = round(float(of_edge[at]) * 10**DIGITS)
                key = (int(self.points.table.edge[patch, number]), along)
        if key not in self.known:
            self.known[key] = self.count + len(self.known)
        return self.known[key]


def _curves_of(triangles: Array, chains: list[tuple[int, Array]]) -> Ints:
    """Return the curve along which each side of triangles in (u, v) runs, -1 where none does."""
    result = np.full(triangles.shape[:2], -1, dtype=np.int64)
    if not chains or not len(triangles):
        return result
    middles = 0.5 * (triangles + np.roll(triangles, -1, axis=1))
    for number in sorted({number for number, _ in chains}):
        lines = shapely.multilinestrings(
            [shapely.linestrings(chain) for curve, chain in chains if curve == number]
        )
        shapely.prepare(lines)
        at_corner = _near(triangles, lines)
        on = at_corner & np.roll(at_corner, -1, axis=1)
        on[on] = _near(middles[on], lines)
        result[on] = number
    return result


def _near(points: Array, lines: Any) -> Bools:
    flat = shapely.points(points.reshape(-1, 2))
    near = np.asarray(shapely.dwithin(lines, flat, ON_CURVE), dtype=np.bool_)
    return near.reshape(points.shape[:-1])


def _with_both_sides(mesh: CutMesh) -> CutMesh:
    """Return the mesh with each part of a curve known on both of its sides."""
    start, stop = mesh.vertex, np.roll(mesh.vertex, -1, axis=1)
    key = np.stack([np.minimum(start, stop), np.maximum(start, stop)], axis=2).reshape(-1, 2)
    _, edge = np.unique(key, axis=0, return_inverse=True)
    edge = edge.reshape(-1)
    curve = np.full(int(edge.max()) + 1, -1, dtype=np.int64)
    np.maximum.at(curve, edge, mesh.curve.ravel())
    return CutMesh(mesh.patch, mesh.parameters, mesh.vertex, curve[edge].reshape(-1, 3))
