"""Pieces on a sheet in millimeters: their cut lines, and where each lies."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece
from bodymeasure.pattern.planar import shapely

# The distance between pieces and to the edge of the sheet, in millimeters.
GAP = 25.0
# Room below the pieces for the square by which a print is checked.
BELOW = 40.0
# How far, in allowances, a corner of the cut line may stand out; sharper ones are cut off.
MITRE = 2.5


@dataclass(frozen=True, eq=False)
class Placed:
    """A piece on the sheet.

    Parameters
    ----------
    piece : Piece
    cut : ndarray, shape (m, 2)
        The line along which it is cut out, on the sheet.
    scale : float
        Millimeters for one of the atlas's units.
    offset : ndarray, shape (2,)
        Where the piece's origin lies on the sheet, in millimeters.
    """

    piece: Piece
    cut: Array
    scale: float
    offset: Array

    def on_sheet(self, points: Array) -> Array:
        """Return points of the piece on the sheet, whose second axis points down."""
        return np.asarray(points * [self.scale, -self.scale] + self.offset)


@dataclass(frozen=True, eq=False)
class Sheet:
    """All pieces of a pattern side by side.

    Parameters
    ----------
    placed : tuple of Placed
    width, height : float
        In millimeters.
    """

    placed: tuple[Placed, ...]
    width: float
    height: float


def sheet_of(pattern: Pattern, allowance: float) -> Sheet:
    """Lay out the pieces of a pattern; the allowance is in millimeters."""
    scale = 1000.0 * pattern.atlas.unit.meters
    x, tallest = GAP, 0.0
    placed = []
    for piece in pattern.pieces:
        cut = cut_line(piece, allowance / scale) * [scale, -scale]
        low, high = cut.min(axis=0), cut.max(axis=0)
        offset = np.array([x, GAP]) - low
        placed.append(Placed(piece, cut + offset, scale, offset))
        x += float(high[0] - low[0]) + GAP
        tallest = max(tallest, float(high[1] - low[1]))
    return Sheet(tuple(placed), x, tallest + 2.0 * GAP + BELOW)


def sew_area(piece: Piece) -> Any:
    """Return the area inside the sew line, with the darts closed by straight lines."""
    rows = [part for edge in piece.edges for part in edge.parts]
    # A piece whose atlas faces inwards is drawn the other way round.
    return shapely.make_valid(shapely.polygons(np.concatenate(rows)))


def cut_line(piece: Piece, allowance: float) -> Array:
    """Return the line along which a piece is cut out, in the atlas's unit, closed.

    The allowance is added all round but at the fold, which lies on the fold of the cloth.
    """
    area = sew_area(piece)
    if allowance > 0.0:
        area = shapely.buffer(area, allowance, join_style="mitre", mitre_limit=MITRE)
    if piece.panel.fold:
        side = np.sign(np.median(piece.outline[:, 0]))
        low, _, high, _ = shapely.bounds(sew_area(piece)).tolist()
        far = 2.0 * (abs(low) + abs(high) + allowance + 1.0)
        y = shapely.bounds(area)[[1, 3]]
        half = shapely.box(
            *(
                (0.0, y[0] - 1.0, far, y[1] + 1.0)
                if side > 0.0
                else (-far, y[0] - 1.0, 0.0, y[1] + 1.0)
            )
        )
        area = shapely.intersection(area, half)
    if area.geom_type != "Polygon":
        area = max(shapely.get_parts(area), key=shapely.area)
    return np.asarray(shapely.get_coordinates(shapely.get_exterior_ring(area)))
