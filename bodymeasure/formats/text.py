"""Text files of numbers: their lines, and the numbers on them."""

import bisect
import codecs
import math
import re
from array import array
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError

# How many characters of an offending word an error quotes.
_QUOTED = 24
# Byte order marks and the encodings that they tell; that of UTF-32 begins with that of UTF-16.
_MARKS = {
    codecs.BOM_UTF8: "utf-8",
    codecs.BOM_UTF32_LE: "utf-32-le",
    codecs.BOM_UTF32_BE: "utf-32-be",
    codecs.BOM_UTF16_LE: "utf-16-le",
    codecs.BOM_UTF16_BE: "utf-16-be",
}
# So many words at least become numbers at once.
_AT_ONCE = 65_536
_ALL = slice(None)
_REMARK = re.compile(rb"(?:^|(?<=\s))#.*", re.DOTALL)


@dataclass(frozen=True)
class TextFile:
    """The lines of a text file; iterating gives the number, from 1, and the words of each line.

    Parameters
    ----------
    source : str
        Names the file in errors.
    lines : list of bytes
        Without what follows ``#`` at the beginning of a word.
    """

    source: str
    lines: list[bytes]

    @classmethod
    def parse(
        cls, content: bytes, source: str, *, continued: bool = False, names: Collection[bytes] = ()
    ) -> Self:
        """The lines of a file's content, in UTF-8 if a byte order mark tells the encoding.

        With `continued`, a backslash at the end of a line makes the next line part of it. On lines
        that begin with one of the words `names`, all that follows is a name, with any ``#`` in it.

        Raises
        ------
        InputError
            If nothing is on them, or the content is binary.
        """
        content = _decoded(content, source)
        if b"\0" in content:
            raise InputError(f"{source}: is binary; expected text")
        lines = content.splitlines()
        if b"#" in content:
            lines = [
                _REMARK.sub(b"", line)
                if b"#" in line and line.split(None, 1)[0] not in names
                else line
                for line in lines
            ]
        if continued and b"\\" in content:
            lines = _joined(lines)
        if not any(line.strip() for line in lines):
            raise InputError(f"{source}: is empty; expected patches")
        return cls(source, lines)

    def __iter__(self) -> Iterator[tuple[int, list[bytes]]]:
        for number, line in enumerate(self.lines, 1):
            words = line.split()
            if words:
                yield number, words

    def place(self, line: int) -> str:
        """The words by which an error names a line."""
        return f"{self.source}, line {line}"


def _decoded(content: bytes, source: str) -> bytes:
    """The content without its byte order mark, and in UTF-8 where the mark tells UTF-16 or 32."""
    for mark, encoding in _MARKS.items():
        if content.startswith(mark):
            content = content.removeprefix(mark)
            if encoding == "utf-8":
                return content
            try:
                return content.decode(encoding).encode()
            except UnicodeDecodeError as error:
                raise InputError(
                    f"{source}: begins as text in {encoding.upper()}, but byte "
                    f"{len(mark) + error.start} is no such text; expected text; save the file in "
                    "UTF-8"
                ) from None
    return content


def _joined(lines: list[bytes]) -> list[bytes]:
    """Lines with those appended that a backslash continues; these are left empty themselves."""
    result: list[bytes] = []
    parts: list[bytes] = []
    for line in lines:
        stripped = line.rstrip()
        goes_on = stripped.endswith(b"\\")
        parts.append(stripped[:-1] if goes_on else line)
        if not goes_on:
            result += [b" ".join(parts), *[b""] * (len(parts) - 1)]
            parts = []
    return [*result, b" ".join(parts)]


class Words:
    """Words that are to be numbers, gathered line by line.

    They become numbers while they are gathered: a word takes ten times the memory of its number.

    Attributes
    ----------
    lines, ends : array of int
        The line that was added each time, and the number of words until its end.
    bad : dict
        The words that are no finite numbers, by their number.
    """

    def __init__(self) -> None:
        self.lines, self.ends = array("q"), array("q")
        self.bad: dict[int, bytes] = {}
        self._values, self._waiting = array("d"), list[bytes]()

    def __len__(self) -> int:
        return len(self._values) + len(self._waiting)

    def add(self, line: int, words: Sequence[bytes]) -> None:
        """Add the words of a line."""
        self._waiting += words
        self.lines.append(line)
        self.ends.append(len(self))
        if len(self._waiting) >= _AT_ONCE:
            self._convert()

    def _convert(self) -> None:
        words, self._waiting = self._waiting, []
        try:
            values = array("d", map(float, words))
            # Python reads 1_000 as a number; no file format does.
            sound = bool(np.isfinite(values).all()) and b"_" not in b"".join(words)
        except ValueError:
            sound = False
        if not sound:
            first = len(self._values)
            bad = {number: word for number, word in enumerate(words) if not _is_number(word)}
            self.bad |= {first + number: word for number, word in bad.items()}
            values = array("d", (0.0 if k in bad else float(word) for k, word in enumerate(words)))
        self._values += values

    def line_of(self, word: int) -> int:
        """The line on which a word stands."""
        return self.lines[bisect.bisect_right(self.ends, word)]

    def numbers(self, source: str, chosen: Ints | slice = _ALL) -> Array:
        """Return all words, or the chosen ones, as numbers.

        Raises
        ------
        InputError
            If one of these is no finite number; the message names the first such word and its line.
        """
        self._convert()
        if self.bad:
            number = np.arange(len(self))[chosen]
            wrong = number[np.isin(number, list(self.bad))]
            if len(wrong):
                bad = int(wrong.min())
                raise InputError(
                    f"{source}, line {self.line_of(bad)}: {quoted(self.bad[bad])} is not a finite "
                    "number; expected numbers such as 1.25 or -3e-2"
                )
        return np.array(self._values, dtype=np.float64)[chosen]


def few_numbers(words: Sequence[bytes], place: str) -> tuple[float, ...]:
    """Return the numbers on one short line, of which a file may have very many.

    Raises
    ------
    InputError
        If one is no finite number; the message names the first such word.
    """
    try:
        values = tuple(map(float, words))
        if all(map(math.isfinite, values)) and b"_" not in b"".join(words):
            return values
    except ValueError:
        pass
    bad = next(word for word in words if not _is_number(word))
    raise InputError(
        f"{place}: {quoted(bad)} is not a finite number; expected numbers such as 1.25 or -3e-2"
    )


def whole_number(word: bytes, what: str, place: str) -> int:
    """Return a count or an index.

    Raises
    ------
    InputError
        If the word is not a whole number; the message says what was expected.
    """
    try:
        if b"_" not in word:
            return int(word)
    except ValueError:
        pass
    raise InputError(f"{place}: {quoted(word)} is not a whole number; expected {what}")


def decoded(text: bytes) -> str:
    """Return a name in UTF-8, or else in Latin-1, in which every byte is a character."""
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError:
        return text.decode("latin-1")


def quoted(word: bytes) -> str:
    """Return a word as an error shows it: short, and without control characters."""
    text = decoded(word)
    return repr(text if len(text) <= _QUOTED else text[:_QUOTED] + "...")


def written(points: Array) -> list[str]:
    """Return points (n, k) as lines of text, the shortest that are read back to the last bit."""
    return [" ".join(map(repr, row)) for row in points.tolist()]


def _is_number(word: bytes) -> bool:
    try:
        return b"_" not in word and math.isfinite(float(word))
    except ValueError:
        return False
