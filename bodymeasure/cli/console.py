"""Printing: results go to stdout, progress and errors to stderr."""

import errno
import itertools
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.text import Text

from bodymeasure.cli.tables import plain_lines

if TYPE_CHECKING:
    from rich.table import Table


class _Console(Console):
    """Leaves a closed pipe to `main`; rich's own console ends the process with code 1."""

    def on_broken_pipe(self) -> None:
        raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE))


RESULTS = _Console(highlight=False, emoji=False)
ERRORS = _Console(stderr=True, highlight=False, emoji=False)


def print_table(table: "Table") -> None:
    """Print a table to fit the terminal; into a pipe or a file, each row as one plain line."""
    if RESULTS.is_terminal:
        RESULTS.print(table)
        return
    for line in plain_lines(table):
        click.echo(line)


def print_files(files: Iterable[Path]) -> None:
    """Print the names of written files, the first of which is what people look at."""
    for number, path in enumerate(files):
        RESULTS.print(Text(str(path), "" if number else "bold"), soft_wrap=True)


def print_note(text: str, *, style: str = "yellow") -> None:
    """Print a remark to stderr; the terminal breaks long lines."""
    ERRORS.print(Text(text, style), soft_wrap=True)


def print_error(text: str) -> None:
    """Print an error to stderr, in the way in which click prints wrong usage."""
    ERRORS.print(Text.assemble(("Error:", "bold red"), " ", text), soft_wrap=True)


@contextmanager
def progress_bar(label: str, total: int) -> Iterator[Callable[[int], None]]:
    """Show a bar on stderr, if that is a terminal; it is called with how many steps are done."""
    if not ERRORS.is_terminal:
        yield lambda _done: None
        return
    # Slow imports, which `--help` does not need.
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
    )

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, TimeElapsedColumn(), console=ERRORS, transient=True) as progress:
        task = progress.add_task(label, total=total)
        yield lambda done: progress.update(task, completed=done)


def count_calls(progress: Callable[[int], None]) -> Callable[[object], None]:
    """Return a function that tells a progress bar how often it has been called."""
    calls = itertools.count(1)
    return lambda _what: progress(next(calls))
