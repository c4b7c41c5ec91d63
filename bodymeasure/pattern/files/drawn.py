"""A piece as it is drawn, in millimeters: lines, marks, and what is written on it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.definitions.panels import Edge
from bodymeasure.pattern.files.allowance import widened
from bodymeasure.pattern.files.marks import Notch, hole_of, notches_of
from bodymeasure.pattern.flat.smooth_chain import smooth_chain
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece
from bodymeasure.pattern.planar import shapely

# Points nearer than this, in millimeters, are one.
SAME = 1e-6
# How far the cap of a dart may stand out, in lengths of its legs; a blunter one is not capped.
CAP = 1.5


@dataclass(frozen=True, eq=False)
class DrawnEdge:
    """An edge of a piece.

    Parameters
    ----------
    name, seam : str
    parts : tuple of ndarray, shape (m, 2)
        One chain more than there are darts on it.
    allowance : float
    is_fold : bool
    """

    name: str
    seam: str
    parts: tuple[Array, ...]
    allowance: float
    is_fold: bool

    @property
    def length(self) -> float:
        """Its length, without the mouths of darts."""
        return float(sum(np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in self.parts))


@dataclass(frozen=True, eq=False)
class DrawnDart:
    """A dart of a piece.

    Parameters
    ----------
    name : str
    legs : tuple of ndarray, shape (m, 2)
        Both, from their feet to the tip.
    hole : ndarray, shape (2,)
        Where a hole marks it, before its tip.
    """

    name: str
    legs: tuple[Array, Array]
    hole: Array


@dataclass(frozen=True, eq=False)
class DrawnPiece:
    """A piece as it is drawn, in millimeters; its second axis points up, along the grain.

    Its origin is the point that the pieces of all sizes have in common when they are drawn over
    each other: the lower end of the fold or of the grain.

    Parameters
    ----------
    piece : Piece
    size : str
        The name of its size; empty if there is only one.
    cut : ndarray, shape (m, 2)
        The line along which it is cut out, closed.
    edges : tuple of DrawnEdge
    darts : tuple of DrawnDart
    notches : tuple of Notch
    scale : float
        Millimeters for one of the atlas's units.
    origin : ndarray, shape (2,)
        Where the origin lies in the piece, in millimeters.
    """

    piece: Piece
    size: str
    cut: Array
    edges: tuple[DrawnEdge, ...]
    darts: tuple[DrawnDart, ...]
    notches: tuple[Notch, ...]
    scale: float
    origin: Array

    @property
    def name(self) -> str:
        """The piece's name."""
        return self.piece.name

    @property
    def inner(self) -> Any:
        """The area that is free for words: inside the sew line, without the darts."""
        rows = [part for edge in self.edges for part in edge.parts]
        area = shapely.make_valid(shapely.polygons(np.concatenate(rows)))
        for dart in self.darts:
            wedge = np.concatenate([dart.legs[0], dart.legs[1][::-1]])
            area = shapely.difference(area, shapely.make_valid(shapely.polygons(wedge)))
        return area


def drawn_piece(pattern: Pattern, piece: Piece, allowance: float, size: str) -> DrawnPiece:
    """Return a piece as it is drawn; the allowance is that of edges which have none of their own.

    Parameters
    ----------
    pattern : Pattern
    piece : Piece
    allowance : float
        In millimeters.
    size : str
    """
    scale = 1000.0 * pattern.atlas.unit.meters
    panel = piece.panel
    origin = scale * _origin(piece)
    by_name = {edge.name: edge for edge in panel.edge}
    edges = tuple(
        DrawnEdge(
            edge.name,
            edge.seam,
            tuple(smooth_chain(scale * part - origin) for part in edge.parts),
            _allowance(piece, by_name.get(edge.name), allowance),
            edge.name == panel.fold,
        )
        for edge in piece.edges
    )
    drills = {dart.name: 1000.0 * dart.drill for dart in panel.dart}
    darts = tuple(
        _dart(dart.name, [scale * leg - origin for leg in dart.legs], drills.get(dart.name, 0.0))
        for dart in piece.darts
    )
    fold = next((edge.parts[0][[0, -1]] for edge in edges if edge.is_fold), None)
    area = widened(*_border(edges, darts), fold)
    cut = np.asarray(shapely.get_coordinates(area))
    cut = cut[np.append(True, np.linalg.norm(np.diff(cut, axis=0), axis=1) > SAME)]
    notches = notches_of(pattern, panel, (edges, darts), cut)
    return DrawnPiece(piece, size, cut, edges, darts, notches, scale, origin)


def _dart(name: str, legs: list[Array], drill: float) -> DrawnDart:
    one, other = (smooth_chain(leg) for leg in legs)
    return DrawnDart(name, (one, other), hole_of(one, other, drill))


def _allowance(piece: Piece, edge: Edge | None, asked: float) -> float:
    if edge is not None and edge.name == piece.panel.fold:
        return 0.0
    own = edge.allowance if edge is not None else None
    given = piece.panel.allowance if own is None else own
    return asked if given is None else 1000.0 * given


def _border(edges: tuple[DrawnEdge, ...], darts: tuple[DrawnDart, ...]) -> tuple[Array, Array]:
    """Return the sew line, darts closed, counterclockwise, and the allowance of each side."""
    rows: list[Array] = []
    widths: list[Array] = []
    for edge in edges:
        for number, part in enumerate(edge.parts):
            rows.append(part[:-1])
            widths.append(np.full(len(part) - 1, edge.allowance))
            if number < len(edge.parts) - 1:
                feet = part[-1], edge.parts[number + 1][0]
                cap = _cap(part, edge.parts[number + 1], _tip(feet, darts))
                rows.append(np.concatenate([feet[0][None], cap]))
                widths.append(np.full(1 + len(cap), edge.allowance))
    ring, allowance = np.concatenate(rows), np.concatenate(widths)
    apart = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1) > SAME
    ring, allowance = ring[apart], allowance[apart]
    x, y = ring.T
    if x @ np.roll(y, -1) < y @ np.roll(x, -1):
        # A piece whose atlas faces inwards runs clockwise.
        ring, allowance = ring[::-1], np.roll(allowance[::-1], -1)
    return ring, allowance


def _tip(feet: tuple[Array, Array], darts: tuple[DrawnDart, ...]) -> Array | None:
    for dart in darts:
        ends = np.stack([dart.legs[0][0], dart.legs[1][0]])
        if min(np.abs(ends - feet).max(), np.abs(ends[::-1] - feet).max()) < SAME:
            return np.asarray(dart.legs[0][-1])
    return None


def _cap(before: Array, after: Array, tip: Array | None) -> Array:
    """Return the corner of the border at a dart's mouth, shape (1, 2), or none.

    Once the dart is folded, its cloth lies along the edge beside it, and has to reach as far: the
    edge, mirrored at the leg, runs on to the middle of the dart.
    """
    if tip is None:
        return np.empty((0, 2))
    found = []
    middle = 0.5 * (before[-1] + after[0]) - tip
    for foot, neighbor in ((before[-1], before[-2]), (after[0], after[1])):
        leg = (foot - tip) / np.linalg.norm(foot - tip)
        along = neighbor - foot
        mirrored = 2.0 * (along @ leg) * leg - along
        system = np.stack([middle, -mirrored], axis=1)
        if abs(np.linalg.det(system)) < SAME:
            return np.empty((0, 2))
        found.append(np.linalg.solve(system, foot - tip)[0])
    reach = float(np.mean(found))
    return (tip + reach * middle)[None] if 1.0 < reach < CAP else np.empty((0, 2))


def _origin(piece: Piece) -> Array:
    name = piece.panel.grain or piece.panel.fold or piece.panel.edge[0].name
    edge = next((edge for edge in piece.edges if edge.name == name), piece.edges[0])
    ends = edge.parts[0][0], edge.parts[-1][-1]
    return min(ends, key=lambda point: float(point[1]))
