"""A map of how much the cloth of each piece has to give, as an SVG file."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.layout import sheet_of
from bodymeasure.pattern.files.svg import DECIMALS, document, path_data, text
from bodymeasure.pattern.patches.colors import color_of, colors_of
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece

# The strain at which the colors of the map end, and the number of colors.
FULL_STRAIN, COLORS = 0.15, 32
# In millimeters: the room around a piece in a picture of its own.
RIM = 3.0
# In millimeters: the bar of colors, from its left upper corner, and the words.
BAR, TEXT = (10.0, 8.0, 128.0, 8.0), 6.0


def strain_svg(pattern: Pattern) -> str:
    """Return an SVG file that shows how much the cloth of each piece has to give."""
    sheet = sheet_of(pattern, 0.0)
    body = [*_bar()]
    for nest in sheet.nests:
        (piece,) = nest.pieces
        flat = nest.on_sheet(piece.scale * piece.piece.positions - piece.origin)
        body += _paths(piece.piece, flat)
        words = f"{piece.name}: {100.0 * piece.piece.rms_strain:.1f} % rms"
        place = nest.on_sheet(nest.marks.label.center)
        # A pale band keeps the words readable on any color.
        more = ' stroke="white" stroke-width="2" stroke-linejoin="round" paint-order="stroke"'
        body.append(text(place, words, nest.marks.label.height, anchor="middle", more=more))
    return document(sheet, body)


def strain_pictures(pattern: Pattern) -> dict[str, tuple[str, float, float]]:
    """Return the map of each piece as an SVG element, with its width and height in millimeters."""
    found = {}
    for nest in sheet_of(pattern, 0.0).nests:
        (piece,) = nest.pieces
        flat = piece.scale * piece.piece.positions * [1.0, -1.0]
        low = flat.min(axis=0) - RIM
        width, height = (flat.max(axis=0) + RIM - low).tolist()
        edges = " ".join(
            path_data(piece.scale * part * [1.0, -1.0] - low, 1)
            for edge in piece.piece.edges
            for part in edge.parts
        )
        legs = " ".join(
            path_data(piece.scale * leg * [1.0, -1.0] - low, 1)
            for dart in piece.piece.darts
            for leg in dart.legs
        )
        lines = f'<path d="{edges} {legs}" fill="none" stroke="#1a1a1e" stroke-width="1"/>'
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.1f} {height:.1f}">'
        drawing = [head, *_paths(piece.piece, flat - low, 1), lines, "</svg>"]
        found[piece.name] = "".join(drawing), width, height
    return found


def strain_colors(strain: Array) -> Array:
    """Return the colors of strains as red, green and blue in [0, 1], shape (n, 3)."""
    return colors_of(strain / FULL_STRAIN)


def _paths(piece: Piece, flat: Array, decimals: int = DECIMALS) -> list[str]:
    """Return the triangles of a piece at places on the sheet, one path for each color."""
    strain = np.abs(piece.strains).max(axis=1) / FULL_STRAIN
    bins: dict[str, list[str]] = {}
    corners = flat[piece.flat.mesh.triangles]
    for triangle, value in zip(corners, strain.tolist(), strict=True):
        color = color_of(round(COLORS * value) / COLORS)
        bins.setdefault(color, []).append(path_data(triangle, decimals) + "Z")
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
