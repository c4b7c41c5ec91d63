"""Patterns as SVG files in millimeters."""

import re
from html import escape

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.drawn import DrawnPiece
from bodymeasure.pattern.files.labels import Marks
from bodymeasure.pattern.files.layout import SQUARE, TITLE, Nest, Sheet, sheet_of
from bodymeasure.pattern.pieces.graded import GradedPattern
from bodymeasure.pattern.pieces.pattern import Pattern

# Sizes of arrows and holes in millimeters.
ARROW, HOLE = 4.0, 1.5
# The decimals of coordinates: a hundredth of what a plotter can do.
DECIMALS = 4
# In millimeters: the names of sizes, and where they stand from their places.
SIZE, BESIDE = 3.5, np.array([1.0, -1.0])
SEW = "#1f4e9e"
# Sizes are told apart by how their cut lines are broken, which a black print shows, too.
DASHES = ("", "10 3", "6 2", "10 2 2 2", "3 2", "12 2 2 2 2 2", "1.5 1.5", "8 2 3 2")


def pattern_svg(pattern: Pattern | GradedPattern, *, allowance: float = 10.0) -> str:
    """Return an SVG file of a pattern in true size.

    Parameters
    ----------
    pattern : Pattern or GradedPattern
        Of several sizes, each piece is drawn in all of them over each other.
    allowance : float
        Of seams, in millimeters, where their panels do not say otherwise.

    Notes
    -----
    The unit is the millimeter. Each edge is one path whose ``id`` is ``PIECE.sew.EDGE``, with
    hyphens for what is no letter or digit, and the size before it where there are several; an edge
    with a dart has one subpath on either side. Alike are ``PIECE.cut``, ``PIECE.dart.DART``,
    ``PIECE.hole.DART``, ``PIECE.notches``, ``PIECE.grain`` and ``PIECE.fold``.
    """
    sheet = sheet_of(pattern, allowance)
    body = [_square(sheet)]
    for nest in sheet.nests:
        body.append(f'<g id="{path_id(nest.name)}">')
        for number, piece in enumerate(nest.pieces):
            body += _piece(nest, piece, DASHES[number % len(DASHES)])
        for place, piece in zip(nest.on_sheet(nest.size_places), nest.pieces, strict=True):
            if piece.size:
                body.append(text(place + BESIDE, piece.size, SIZE))
        body += [*_marks(nest), "</g>"]
    return document(sheet, body)


def path_id(*names: str) -> str:
    """Return the ``id`` of an element from names; empty ones are left out."""
    return ".".join(re.sub(r"[^0-9A-Za-z]+", "-", name).strip("-") or "x" for name in names if name)


def document(sheet: Sheet, body: list[str]) -> str:
    """Return an SVG file from elements on a sheet."""
    size = (
        f'width="{sheet.width:.1f}mm" height="{sheet.height:.1f}mm" '
        f'viewBox="0 0 {sheet.width:.1f} {sheet.height:.1f}"'
    )
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif">'
    title = f"<title>{escape(': '.join(sheet.title[:2]))}</title>"
    paper = '<rect width="100%" height="100%" fill="white"/>'
    return "\n".join([head, title, paper, *body, "</svg>", ""])


def _piece(nest: Nest, piece: DrawnPiece, dashes: str) -> list[str]:
    names = (piece.size, piece.name)
    broken = f' stroke-dasharray="{dashes}"' if dashes else ""
    cut = path_data(nest.on_sheet(piece.cut[:-1])) + "Z"
    parts = [_line(path_id(*names, "cut"), cut, "black", 0.6, broken)]
    for edge in piece.edges:
        d = " ".join(path_data(nest.on_sheet(part)) for part in edge.parts)
        dash = ' stroke-dasharray="12 3 2 3"' if edge.is_fold else ""
        title = f"{edge.name}: {edge.length:.1f} mm"
        parts.append(_line(path_id(*names, "sew", edge.name), d, SEW, 0.4, dash, title))
    for dart in piece.darts:
        d = " ".join(path_data(nest.on_sheet(leg)) for leg in dart.legs)
        dash = ' stroke-dasharray="4 2"'
        parts.append(_line(path_id(*names, "dart", dart.name), d, SEW, 0.4, dash))
        x, y = nest.on_sheet(dart.hole).tolist()
        parts.append(
            f'<circle id="{path_id(*names, "hole", dart.name)}" cx="{x:.{DECIMALS}f}" '
            f'cy="{y:.{DECIMALS}f}" r="{HOLE:g}" fill="none" stroke="black" stroke-width="0.3"/>'
        )
    if piece.notches:
        d = " ".join(path_data(nest.on_sheet(notch.line)) for notch in piece.notches)
        parts.append(_line(path_id(*names, "notches"), d, "black", 0.6))
    return parts


def _marks(nest: Nest) -> list[str]:
    marks = nest.marks
    parts = [
        text(place, line, marks.label.height, anchor="middle")
        for place, line in zip(nest.on_sheet(marks.label.places), marks.label.lines, strict=True)
    ]
    for name, lines in (("grain", grain_lines(marks)), ("fold", fold_lines(marks))):
        if lines:
            d = " ".join(path_data(nest.on_sheet(line)) for line in lines)
            parts.append(_line(path_id(nest.name, name), d, "black", 0.3))
    if marks.fold is not None:
        x, y = nest.on_sheet(marks.fold[1:3].mean(axis=0)).tolist()
        turn = f' transform="rotate(-90 {x:.2f} {y:.2f})"'
        shift = -1.5 if marks.fold[1, 0] < marks.fold[0, 0] else 4.5
        parts.append(text(np.array([x, y + shift]), "on the fold", 3.5, anchor="middle", more=turn))
    return parts


def grain_lines(marks: Marks) -> list[Array]:
    """Return the grain as lines with a head at both ends."""
    if marks.grain is None:
        return []
    low, high = marks.grain
    return [marks.grain, _head(low, np.array([0.0, -1.0])), _head(high, np.array([0.0, 1.0]))]


def fold_lines(marks: Marks) -> list[Array]:
    """Return the bracket at a fold as lines with heads that point to the fold."""
    if marks.fold is None:
        return []
    towards = marks.fold[0] - marks.fold[1]
    towards = towards / np.linalg.norm(towards)
    return [marks.fold, _head(marks.fold[0], towards), _head(marks.fold[3], towards)]


def _head(tip: Array, towards: Array) -> Array:
    aside = 0.4 * ARROW * np.array([-towards[1], towards[0]])
    foot = tip - ARROW * towards
    return np.stack([foot + aside, tip, foot - aside])


def _square(sheet: Sheet) -> str:
    x, y = sheet.corner.tolist()
    words = [
        text(place, line, TITLE)
        for place, line in zip(sheet.title_places, sheet.title, strict=True)
    ]
    return "\n".join(
        [
            f'<rect id="test-square" x="{x:g}" y="{y:g}" width="{SQUARE:g}" '
            f'height="{SQUARE:g}" fill="none" stroke="black" stroke-width="0.2"/>',
            text(sheet.corner + np.array([3.0, SQUARE - 3.0]), f"{SQUARE:g} mm", TITLE),
            *words,
        ]
    )


def _line(name: str, d: str, color: str, width: float, more: str = "", title: str = "") -> str:
    inner = f"><title>{escape(title)}</title></path>" if title else "/>"
    return (
        f'<path id="{name}" d="{d}" fill="none" stroke="{color}" stroke-width="{width:g}"{more}'
        f"{inner}"
    )


def path_data(points: Array, decimals: int = DECIMALS) -> str:
    """Return points as the data of a path."""
    return "M" + " L".join(
        ",".join(f"{x:.{decimals}f}" for x in point) for point in points.tolist()
    )


def text(place: Array, words: str, height: float, *, anchor: str = "start", more: str = "") -> str:
    """Return words at a place of the sheet."""
    return (
        f'<text x="{place[0]:.2f}" y="{place[1]:.2f}" font-size="{height:g}" '
        f'text-anchor="{anchor}"{more}>{escape(words)}</text>'
    )
