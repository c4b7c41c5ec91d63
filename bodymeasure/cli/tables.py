"""Tables for the terminal: lists with a heading for each column, and lists of facts."""

from collections.abc import Collection, Iterator
from itertools import zip_longest

from rich.cells import cell_len
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text


def new_table(*headings: str, words: Collection[str] = (), title: str = "") -> Table:
    """Return an empty table without lines.

    Parameters
    ----------
    *headings : str
        The first column and those in `words` hold words, which may be broken into lines; the
        others hold numbers, which are aligned right and never broken.
    words : collection of str
    title : str
    """
    table = Table(
        title=Text(title) if title else None,
        title_justify="left",
        title_style="bold",
        box=None,
        pad_edge=False,
    )
    for number, heading in enumerate(headings):
        if number and heading not in words:
            table.add_column(heading, justify="right", no_wrap=True)
        else:
            table.add_column(heading, overflow="fold")
    return table


def facts_table(title: str) -> Table:
    """Return an empty table of facts, with a column for their names and one for their values."""
    table = new_table("", "", words=("",), title=title)
    table.show_header = False
    table.columns[0].style = "dim"
    table.columns[0].no_wrap = True
    return table


def plain_lines(table: Table) -> Iterator[str]:
    """Yield the lines of a table without styles, each row as one line.

    rich itself would take a second for a thousand rows.
    """
    if isinstance(table.title, Text):
        yield table.title.plain
    columns = []
    for column in table.columns:
        cells = [column.header] if table.show_header else []
        words = [_plain(cell) for cell in (*cells, *column.cells)]
        width = max(map(cell_len, words), default=0)
        columns.append([(word, width, column.justify == "right") for word in words])
    for row in zip_longest(*columns):
        padded = (
            " " * (width - cell_len(word)) + word
            if right
            else word + " " * (width - cell_len(word))
            for word, width, right in row
        )
        yield "  ".join(padded).rstrip()


def _plain(cell: RenderableType) -> str:
    return cell.plain if isinstance(cell, Text) else Text.from_markup(str(cell)).plain
