"""Tables for the terminal: lists with a heading for each column, and lists of facts."""

from collections.abc import Collection

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
