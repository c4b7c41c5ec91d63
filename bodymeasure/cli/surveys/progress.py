"""The progress of hours of work: how much is done, and about how much time is left."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from bodymeasure.cli.console import ERRORS, print_note
from bodymeasure.wording import counted

# Where stderr is no terminal, as in the log of a batch system, a line is printed this often, in
# seconds.
LINES = 60.0


class Left:
    """Says how much time is left, by the pace since the first call.

    What was done before the first call has taken no time now.
    """

    def __init__(self) -> None:
        self._begin: tuple[int, float] | None = None

    def words(self, done: int, total: int, now: float) -> str:
        """Return the time left in words; empty while there is nothing to tell it from."""
        if self._begin is None:
            self._begin = done, now
        first, begin = self._begin
        if done >= total or done <= first:
            return ""
        return f"about {duration((now - begin) * (total - done) / (done - first))} left"


def duration(seconds: float) -> str:
    """Return a time in words, as exactly as anybody cares."""
    for unit, size in (("day", 86400.0), ("hour", 3600.0), ("minute", 60.0)):
        if seconds >= 1.95 * size:
            return f"{seconds / size:.0f} {unit}s"
    return counted(max(round(seconds), 1), "second")


@contextmanager
def long_progress(label: str) -> Iterator[Callable[[int, int], None]]:
    """Show a bar with the time left on stderr, or lines now and then; called with done and all."""
    left = Left()
    if not ERRORS.is_terminal:
        said = time.monotonic()

        def say(done: int, total: int) -> None:
            nonlocal said
            now = time.monotonic()
            words = left.words(done, total, now)
            if words and now - said >= LINES:
                said = now
                print_note(f"{label}: {done:,} of {total:,}, {words}", style="dim")

        yield say
        return
    # Slow imports, which `--help` does not need.
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

    columns = (
        TextColumn(label),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[left]}"),
    )
    with Progress(*columns, console=ERRORS, transient=True) as progress:
        task = progress.add_task(label, total=None, left="")

        def show(done: int, total: int) -> None:
            words = left.words(done, total, time.monotonic())
            progress.update(task, completed=done, total=total, left=words)

        yield show
