"""The PDF file of a pattern, read back: its drawing, in millimeters on the sheet."""

import io
import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from pypdf import PageObject, PdfReader
from pypdf.generic import ContentStream

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.pattern import pattern_pdf

MILLIMETERS = 25.4 / 72.0
MARGIN, OVERLAP = 10.0, 10.0
SEW = (0.12, 0.31, 0.62)


class Line(NamedTuple):
    """A line on a page, in millimeters from its lower left corner."""

    points: Array
    color: tuple[float, ...]


def drawn(page: PageObject, reader: PdfReader) -> Iterator[Line]:
    """Yield the lines of a page, with what the matrices before them do."""
    matrix, stack, color = np.eye(3), [], (0.0, 0.0, 0.0)
    chains: list[list[list[float]]] = []
    contents = page.get_contents()
    assert contents is not None
    for operands, operator in ContentStream(contents, reader).operations:
        name = operator.decode()
        if name in ("cm", "m", "l", "re", "RG"):
            values = [float(value) for value in operands]
        if name == "q":
            stack.append((matrix, color))
        elif name == "Q":
            matrix, color = stack.pop()
        elif name == "cm":
            a, b, c, d, e, f = values
            matrix = np.array([[a, b, 0.0], [c, d, 0.0], [e, f, 1.0]]) @ matrix
        elif name == "RG":
            color = tuple(values)  # type: ignore[assignment]
        elif name == "m":
            chains.append([values])
        elif name == "l":
            chains[-1].append(values)
        elif name == "re":
            x, y, w, h = values
            chains.append([[x, y], [x + w, y], [x + w, y + h], [x, y + h], [x, y]])
        elif name in ("S", "n"):
            # Circles are curves, of which only the start is kept.
            for chain in (c for c in chains if name == "S" and len(c) > 1):
                places = np.pad(np.array(chain), ((0, 0), (0, 1)), constant_values=1.0) @ matrix
                yield Line(places[:, :2] * MILLIMETERS, color)
            chains = []


def tile(page: PageObject) -> tuple[int, int]:
    found = re.search(r"row (\d+), column (\d+)", page.extract_text())
    assert found is not None
    return int(found[1]), int(found[2])


@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_tiles_carry_the_sew_lines_in_true_size(bodice: bm.Pattern, paper: str) -> None:
    reader = PdfReader(io.BytesIO(pattern_pdf(bodice, paper=paper)))
    width, height = (float(side) * MILLIMETERS for side in reader.pages[0].mediabox[2:])
    assert (width, height) == pytest.approx(
        {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}[paper], abs=0.01
    )
    step = np.array([width, height]) - 2.0 * MARGIN - OVERLAP
    total, squares = 0.0, []
    for page in reader.pages:
        row, column = tile(page)
        lines = [*drawn(page, reader)]
        sewn = [line.points for line in lines if line.color == SEW]
        # What neighbors have in common is counted on the left and on the upper one.
        low = np.array([MARGIN + OVERLAP * (column > 1), MARGIN])
        high = np.array([width - MARGIN, height - MARGIN - OVERLAP * (row > 1)])
        window = shapely.box(*low, *high)
        shown = [shapely.intersection(window, shapely.linestrings(line)) for line in sewn]
        total += float(sum(shapely.length(line) for line in shown))
        for line in lines:
            size = np.ptp(line.points, axis=0)
            if len(line.points) == 5 and size == pytest.approx(50.0, abs=0.001):
                inside = shapely.box(MARGIN, MARGIN, width - MARGIN, height - MARGIN)
                squares += [inside.contains(shapely.linestrings(line.points))]
    # The square is drawn on each page that it might touch, and seen as a whole on one.
    assert sum(squares) == 1
    expected = sum(edge.skin_length for piece in bodice.pieces for edge in piece.edges)
    darts = sum(2.0 * dart.length for piece in bodice.pieces for dart in piece.darts)
    assert total == pytest.approx(1000.0 * (expected + darts), abs=0.01)
    assert (step > 0.0).all()


def test_only_sheets_that_carry_something(bodice: bm.Pattern) -> None:
    reader = PdfReader(io.BytesIO(pattern_pdf(bodice)))
    assert len(reader.pages) == 6
    places = [tile(page) for page in reader.pages]
    assert places == [(row, column) for row in (1, 2) for column in (1, 2, 3)]
    words = "".join(page.extract_text() for page in reader.pages)
    assert "bodice front" in words
    assert "Fitted bodice" in words
    assert "50 mm" in words


def test_a_plotter_gets_one_sheet(bodice: bm.Pattern) -> None:
    content = pattern_pdf(bodice, paper="a0")
    reader = PdfReader(io.BytesIO(content))
    assert len(reader.pages) == 1
    assert content == pattern_pdf(bodice, paper="a0")


def test_unknown_paper_is_refused(bodice: bm.Pattern) -> None:
    with pytest.raises(InputError, match="no paper is named 'a5'; expected one of"):
        pattern_pdf(bodice, paper="a5")
