"""Patterns as SVG files in millimeters."""

import re
from html import escape

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.layout import Placed, Sheet, sew_area, sheet_of
from bodymeasure.pattern.patches.colors import color_of
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.planar import shapely

# Sizes in millimeters: of text, of arrows, and of the square by which a print is checked.
TEXT, ARROW, SQUARE = 6.0, 4.0, 50.0
# The decimals of coordinates: a hundredth of what a plotter can do.
DECIMALS = 4
# Darts are marked this far before their tip, so that the hole of the drill is not seen.
HOLE_BEFORE, HOLE = 10.0, 1.5
# The strain at which the colors of the map end.
FULL_STRAIN = 0.15


def pattern_svg(pattern: Pattern, *, allowance: float = 10.0) -> str:
    """Return an SVG file of a pattern in true size.

    Parameters
    ----------
    pattern : Pattern
    allowance : float
        Of seams, in millimeters.

    Notes
    -----
    The unit is the millimeter. Each edge is one path whose ``id`` is ``PIECE.sew.EDGE``, with
    hyphens for what is no letter or digit; an edge with a dart has one subpath on either side.
    """
    sheet = sheet_of(pattern, allowance)
    body = [*(_piece(placed) for placed in sheet.placed), _square(sheet)]
    return _document(sheet, pattern, body)


def strain_svg(pattern: Pattern) -> str:
    """Return an SVG file that shows how much the cloth of each piece has to give."""
    sheet = sheet_of(pattern, 0.0)
    body = []
    for placed in sheet.placed:
        piece = placed.piece
        flat = placed.on_sheet(piece.positions)
        triangles = piece.flat.mesh.triangles
        strain = np.abs(piece.strains).max(axis=1) / FULL_STRAIN
        bins: dict[str, list[str]] = {}
        for corners, value in zip(flat[triangles], strain.tolist(), strict=True):
            bins.setdefault(color_of(round(32.0 * value) / 32.0), []).append(_path(corners) + "Z")
        body += [
            f'<path d="{" ".join(paths)}" fill="{color}" stroke="{color}" stroke-width="0.3"/>'
            for color, paths in bins.items()
        ]
        words = f"{piece.name}: {100.0 * piece.rms_strain:.1f} % rms"
        body.append(_text(placed.cut.mean(axis=0), words, anchor="middle", fill="white"))
    body += [
        f'<rect x="{10 + i:g}" y="4" width="1.1" height="6" fill="{color_of(i / 63)}"/>'
        for i in range(64)
    ]
    scale = f"largest strain: 0 to {100 * FULL_STRAIN:.0f} % or more"
    body.append(_text(np.array([78.0, 9.0]), scale))
    return _document(sheet, pattern, body)


def path_id(*names: str) -> str:
    """Return the ``id`` of an element from names."""
    return ".".join(re.sub(r"[^0-9A-Za-z]+", "-", name).strip("-") or "x" for name in names)


def _document(sheet: Sheet, pattern: Pattern, body: list[str]) -> str:
    size = (
        f'width="{sheet.width:.1f}mm" height="{sheet.height:.1f}mm" '
        f'viewBox="0 0 {sheet.width:.1f} {sheet.height:.1f}"'
    )
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif">'
    title = f"<title>{escape(f'{pattern.definitions.name}: {pattern.atlas.name}')}</title>"
    paper = '<rect width="100%" height="100%" fill="white"/>'
    return "\n".join([head, title, paper, *body, "</svg>", ""])


def _piece(placed: Placed) -> str:
    piece = placed.piece
    parts = [
        f'<path id="{path_id(piece.name, "cut")}" d="{_path(placed.cut)}Z" fill="none" '
        'stroke="black" stroke-width="0.6"/>'
    ]
    for edge in piece.edges:
        d = " ".join(_path(placed.on_sheet(part)) for part in edge.parts)
        dash = ' stroke-dasharray="12 3 2 3"' if edge.name == piece.panel.fold else ""
        title = f"{edge.name}: {edge.length * placed.scale:.1f} mm"
        parts.append(
            f'<path id="{path_id(piece.name, "sew", edge.name)}" d="{d}" fill="none" '
            f'stroke="#1f4e9e" stroke-width="0.4"{dash}><title>{escape(title)}</title></path>'
        )
    for dart in piece.darts:
        d = " ".join(_path(placed.on_sheet(leg)) for leg in dart.legs)
        parts.append(
            f'<path id="{path_id(piece.name, "dart", dart.name)}" d="{d}" fill="none" '
            'stroke="#1f4e9e" stroke-width="0.4" stroke-dasharray="4 2"/>'
        )
        middle = 0.5 * (dart.legs[0][0] + dart.legs[1][0])
        feet, tip = placed.on_sheet(np.stack([middle, dart.legs[0][-1]]))
        before = tip + HOLE_BEFORE * (feet - tip) / np.linalg.norm(feet - tip)
        parts.append(
            f'<circle cx="{before[0]:.3f}" cy="{before[1]:.3f}" r="{HOLE:g}" fill="none" '
            'stroke="black" stroke-width="0.3"/>'
        )
    parts += _labels(placed)
    group = f'<g id="{path_id(piece.name)}">'
    return "\n".join([group, *parts, "</g>"])


def _labels(placed: Placed) -> list[str]:
    """Return the grain and the words, inside the piece."""
    piece = placed.piece
    area = shapely.polygons(placed.on_sheet(shapely.get_coordinates(sew_area(piece).exterior)))
    for dart in piece.darts:
        wedge = np.concatenate([dart.legs[0], dart.legs[1][::-1]])
        area = shapely.difference(area, shapely.polygons(placed.on_sheet(wedge)).buffer(1.0))
    center = shapely.get_coordinates(shapely.maximum_inscribed_circle(area))[0]
    words = [piece.name, *([f"cut {piece.panel.cut}"] if piece.panel.cut else [])]
    result = [
        _text(center + np.array([0.0, 1.4 * TEXT * row]), line, anchor="middle")
        for row, line in enumerate(words)
    ]
    low, high = area.bounds[1], area.bounds[3]
    below = 1.4 * TEXT * (len(words) + 0.5)
    x = float(center[0])
    grain = np.array([[x, center[1] + below], [x, center[1] + below + 0.3 * (high - low)]])
    inside = shapely.intersection(area.buffer(-TEXT), shapely.linestrings(grain))
    if not inside.is_empty and inside.geom_type == "LineString":
        top, bottom = sorted(shapely.get_coordinates(inside).tolist(), key=lambda point: point[1])
        tips = [
            np.array(
                [
                    [end[0] - 0.4 * ARROW, end[1] + way * ARROW],
                    end,
                    [end[0] + 0.4 * ARROW, end[1] + way * ARROW],
                ]
            )
            for end, way in ((top, 1.0), (bottom, -1.0))
        ]
        d = " ".join(_path(line) for line in (np.array([top, bottom]), *tips))
        result.append(
            f'<path id="{path_id(piece.name, "grain")}" d="{d}" fill="none" stroke="black" '
            'stroke-width="0.3"/>'
        )
    return result


def _square(sheet: Sheet) -> str:
    y = sheet.height - SQUARE - 5.0
    return (
        f'<rect id="test-square" x="5" y="{y:.3f}" width="{SQUARE:g}" height="{SQUARE:g}" '
        'fill="none" stroke="black" stroke-width="0.2"/>'
        + _text(np.array([7.0, y + SQUARE - 3.0]), "50 mm")
    )


def _path(points: Array) -> str:
    return "M" + " L".join(
        ",".join(f"{x:.{DECIMALS}f}" for x in point) for point in points.tolist()
    )


def _text(place: Array, words: str, *, anchor: str = "start", fill: str = "black") -> str:
    return (
        f'<text x="{place[0]:.2f}" y="{place[1]:.2f}" font-size="{TEXT:g}" fill="{fill}" '
        f'text-anchor="{anchor}">{escape(words)}</text>'
    )
