"""The parts of a survey that are done, one file for each batch, until the table is written."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

from bodymeasure.errors import InputError
from bodymeasure.files import make_folder, read_bytes, write_bytes
from bodymeasure.surveys.records import Row, rows_from_bytes, rows_to_bytes

FOLDER = "parts"
SUFFIX = ".part"
# Files of one folder, so that no folder becomes slow.
TOGETHER = 1000


class Parts:
    """The parts in the folder of a survey.

    A part is written whole or not at all, so that a survey that is killed leaves nothing
    half-written.

    Parameters
    ----------
    folder : Path
        Of the survey.
    count : int
        The number of batches.
    """

    def __init__(self, folder: Path, count: int) -> None:
        self.folder, self.count = folder / FOLDER, count
        self.done: set[int] = set()
        for number in range(count):
            if self._path(number).is_file():
                self.done.add(number)
        # What a run that was killed was about to write.
        for leftover in self.folder.glob("*/.bodymeasure-*"):
            leftover.unlink(missing_ok=True)

    def _path(self, number: int) -> Path:
        return self.folder / f"{number // TOGETHER:04}" / f"{number:07}{SUFFIX}"

    def write(self, number: int, rows: Sequence[Row]) -> None:
        """Write the rows of a batch."""
        path = self._path(number)
        make_folder(path.parent)
        write_bytes(path, rows_to_bytes(rows))
        self.done.add(number)

    def rows(self, number: int) -> list[Row]:
        """Return the rows of a batch.

        Raises
        ------
        InputError
            If its file is damaged.
        """
        path = self._path(number)
        return rows_from_bytes(read_bytes(path), str(path))

    def __iter__(self) -> Iterator[list[Row]]:
        """Yield the rows of all batches, in their order."""
        for number in range(self.count):
            yield self.rows(number)

    def require_whole(self, sizes: Sequence[int]) -> None:
        """Have parts measured again that do not hold as many rows as their batches have bodies."""
        for number in sorted(self.done):
            try:
                found = len(self.rows(number))
            except InputError:
                found = -1
            if found != sizes[number]:
                self._path(number).unlink()
                self.done.discard(number)

    def remove(self) -> None:
        """Remove all parts, when the table has what they hold."""
        for number in range(self.count):
            self._path(number).unlink(missing_ok=True)
        for folder in (*self.folder.glob("*"), self.folder):
            with suppress(OSError):
                folder.rmdir()
