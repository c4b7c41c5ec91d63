"""A map of how much the cloth of each piece has to give, as an SVG file."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.layout import sheet_of
from bodymeasure.pattern.files.svg import document, path_data, text
from bodymeasure.pattern.patches.colors import color_of
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece

# The strain at which the colors of the map end, and the number of colors.
FULL_STRAIN, COLORS = 0.15, 32
# In millimeters: the bar of colors, from its left upper corner, and the words.
BAR, TEXT = (10.0, 8.0, 128.0, 8.0), 6.0


def strain_svg(pattern: Pattern) -> str:
    """Return an SVG file that shows how much the cloth of each piece has to give."""
    sheet = sheet_of(pattern, 0.0)
    body = [*_bar()]
    for nest in sheet.nests:
        (piece,) = nest.pieces
        flat = nest.on_sheet(piece.scale * piece.piece.positions - piece.origin)
        body += strain_paths(piece.piece, flat)
        words = f"{piece.name}: {100.0 * piece.piece.rms_strain:.1f} % rms"
        place = nest.on_sheet(nest.marks.label.center)
        # A pale band keeps the words readable on any color.
        more = ' stroke="white" stroke-width="2" stroke-linejoin="round" paint-order="stroke"'
        body.append(text(place, words, nest.marks.label.height, anchor="middle", more=more))
    return document(sheet, body)


def strain_paths(piece: Piece, flat: Array) -> list[str]:
    """Return the triangles of a piece at places on the sheet, one path for each color."""
    strain = np.abs(piece.strains).max(axis=1) / FULL_STRAIN
    bins: dict[str, list[str]] = {}
    corners = flat[piece.flat.mesh.triangles]
    for triangle, value in zip(corners, strain.tolist(), strict=True):
        color = color_of(round(COLORS * value) / COLORS)
        bins.setdefault(color, []).append(path_data(triangle) + "Z")
    return [
        f'<path d="{" ".join(paths)}" fill="{color}" stroke="{color}" stroke-width="0.3"/>'
        for color, paths in bins.items()
    ]


def _bar() -> list[str]:
    x, y, width, height = BAR
    step = width / COLORS
    parts = [
        f'<rect x="{x + i * step:g}" y="{y:g}" width="{step + 0.1:g}" height="{height:g}" '
        f'fill="{color_of(i / (COLORS - 1))}"/>'
        for i in range(COLORS)
    ]
    for share in (0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0):
        more = " or more" if share == 1.0 else ""
        words = f"{100.0 * FULL_STRAIN * share:.0f} %{more}"
        place = np.array([x + share * width, y + height + 1.2 * TEXT])
        parts.append(text(place, words, TEXT, anchor="start" if share == 1.0 else "middle"))
    where = np.array([x, y + height + 2.8 * TEXT])
    return [*parts, text(where, "how much the cloth has to give: the larger of both strains", TEXT)]
