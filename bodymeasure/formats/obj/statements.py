"""Wavefront OBJ files as vertices and statements, without regard to their meaning."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.formats.text import TextFile, Words, decoded, quoted, whole_number

# The statements of the format's description that have no bearing on shape: display, materials,
# curves' and points' data, and how surfaces join, which their edges show.
IGNORED = frozenset(
    {"vt", "vn", "vp", "p", "l", "sp", "con", "s", "mg", "bevel", "c_interp", "d_interp"}
    | {"lod", "usemtl", "mtllib", "shadow_obj", "trace_obj", "ctech", "stech", "maplib", "usemap"}
)
MEANINGFUL = frozenset(
    {"cstype", "deg", "bmat", "step", "f", "fo", "curv", "curv2", "surf", "parm", "trim", "hole"}
    | {"scrv", "end", "g", "o", "t", "bzp", "bsp", "cdc", "cdp", "res", "call", "csh"}
)
# Statements whose words are a name, in which # does not begin a remark.
NAMES = frozenset({b"o", b"g"})
# Lines that are no statement and that a note quotes; it counts the others.
_QUOTED_LINES = 4
# A line of so many numbers after an unknown word may be a misspelled vertex or face.
_NUMBERS = 3
# Numbers of a vertex: its coordinates alone, with a weight, with a color, or with both.
_VERTEX_WORDS = (3, 4, 6, 7)
# How many of them are coordinates and weight at most.
_MOST_USED = 4


class Statement(NamedTuple):
    """A line that is no vertex.

    Parameters
    ----------
    keyword : str
    words : list of bytes
        The words that follow it.
    line : int
        Number of the line in the file, from 1.
    vertices : int
        How many vertices came before, from which negative numbers count back.
    """

    keyword: str
    words: list[bytes]
    line: int
    vertices: int


@dataclass(frozen=True, eq=False)
class ObjFile:
    """A file's vertices, with their weights (1 where none is given), and its statements.

    Statements are made when they are asked for: a file may have very many.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    weights : ndarray, shape (n,)
    keywords : frozenset of str
        The statements that occur.
    text : TextFile
    lines, vertices : list of int
        The line of each statement, and how many vertices came before.
    notes : tuple of str
        What was left out.
    """

    points: Array
    weights: Array
    keywords: frozenset[str]
    text: TextFile
    lines: list[int]
    vertices: list[int]
    notes: tuple[str, ...] = ()

    def statements(self) -> Iterator[Statement]:
        """All statements in order."""
        for line, vertices in zip(self.lines, self.vertices, strict=True):
            keyword, *words = self.text.lines[line - 1].split()
            yield Statement(keyword.decode("ascii"), words, line, vertices)


def parse(content: bytes, source: str) -> ObjFile:
    """Read a file's content.

    Raises
    ------
    InputError
        If a vertex is not made of numbers, or a line that is no statement might be meant to change
        the shape; the message has the line.
    """
    file = TextFile.parse(content, source, continued=True, names=NAMES)
    vertices = Words()
    lines: list[int] = []
    before: list[int] = []
    keywords: set[str] = set()
    unknown: list[tuple[int, list[bytes]]] = []
    for line, words in file:
        if words[0] == b"v":
            del words[0]
            vertices.add(line, words)
            continue
        keyword = words[0].decode("ascii", "replace")
        if keyword in MEANINGFUL:
            keywords.add(keyword)
            lines.append(line)
            before.append(len(vertices.lines))
        elif keyword not in IGNORED:
            unknown.append((line, words))
    if unknown:
        head = min((*vertices.lines[:1], *lines[:1]), default=0)
        _check_unknown(unknown, head, "surf" in keywords, file)
    points, weights = _vertices(vertices, source)
    notes = (_left_out(unknown),) if unknown else ()
    return ObjFile(points, weights, frozenset(keywords), file, lines, before, notes)


def _check_unknown(
    unknown: list[tuple[int, list[bytes]]], head: int, free_form: bool, file: TextFile
) -> None:
    """Refuse lines that may be misspelled statements on which the shape depends.

    Lines of numbers may be vertices or faces, and so may those, after the line `head`, the first
    that is known, whose first word has a digit. Free-form surfaces depend on all lines after it.
    """
    for line, words in unknown:
        numbers = all(word.lstrip(b"+-.")[:1].isdigit() for word in words[1:])
        mangled = free_form or any(sign in b"0123456789" for sign in words[0])
        if (line > head and mangled) or (numbers and len(words) > _NUMBERS):
            raise InputError(
                f"{file.place(line)}: begins with {quoted(words[0])}, which is no statement of a "
                "Wavefront OBJ file; correct the line or remove it"
            )


def _left_out(unknown: list[tuple[int, list[bytes]]]) -> str:
    """The note on lines that are no statements."""
    listed = ", ".join(
        f"line {line} ({quoted(words[0])})" for line, words in unknown[:_QUOTED_LINES]
    )
    more = len(unknown) - _QUOTED_LINES
    also = f" and {more} more" if more > 0 else ""
    if len(unknown) == 1:
        return f"{listed} is no statement of a Wavefront OBJ file; it is left out"
    return f"{listed}{also} are no statements of a Wavefront OBJ file; they are left out"


def vertices(content: bytes, source: str) -> Array:
    """Return the vertices (n, 3) in a file's content, whatever else it holds.

    Readers of whole meshes number vertices anew where texture has seams; these keep their numbers.

    Raises
    ------
    InputError
        If a vertex is not made of numbers; the message has the line.
    """
    words = Words()
    for line, (keyword, *numbers) in TextFile.parse(content, source, continued=True, names=NAMES):
        if keyword == b"v":
            words.add(line, numbers)
    return _vertices(words, source)[0]


def _vertices(words: Words, source: str) -> tuple[Array, Array]:
    """Points and weights; a weight is 1 where none is given."""
    ends = np.array(words.ends, dtype=np.int64)
    widths = np.diff(ends, prepend=0)
    wrong = np.flatnonzero(~np.isin(widths, _VERTEX_WORDS))
    if len(wrong):
        raise InputError(
            f"{source}, line {words.lines[wrong[0]]}: a vertex of {widths[wrong[0]]} numbers; "
            "expected v x y z, and perhaps a weight or a color"
        )
    # Colors need not be numbers.
    used = np.where(widths > _MOST_USED, widths - 3, widths)
    last = np.cumsum(used)
    kept = np.arange(used.sum()) + np.repeat(ends - widths - (last - used), used)
    values = words.numbers(source, kept)
    begin = last - used
    weights = np.ones(len(ends))
    weighted = used == 4
    weights[weighted] = values[begin[weighted] + 3]
    return values[begin[:, None] + np.arange(3)], weights


def vertex_numbers(statement: Statement, words: Sequence[bytes], count: int, source: str) -> Ints:
    """The vertices that a statement refers to, from 0.

    The first number of ``v/vt/vn`` counts. Numbers are from 1, or negative; these count back from
    the vertices that came before the statement.

    Raises
    ------
    InputError
        If a number is not one, or there is no such vertex among the `count` of the file.
    """
    try:
        numbers = np.array([int(word) for word in words], dtype=np.int64)
        if b"_" in b"".join(words):
            raise ValueError("Python takes 1_000 for a number")
    except (ValueError, OverflowError):
        numbers = np.array([_number(statement, word, source) for word in words], dtype=np.int64)
    if len(numbers) and numbers.min() > 0 and numbers.max() <= count:
        return numbers - 1
    numbers = np.where(numbers < 0, numbers + statement.vertices, numbers - 1)
    outside = np.flatnonzero((numbers < 0) | (numbers >= count))
    if len(outside):
        back = statement.vertices
        expected = f"expected 1 to {count}" + (f", or -1 to -{back} to count back" if back else "")
        if not count:
            expected = "but the file holds no vertex (v); it may be the part of another file"
        raise InputError(
            f"{source}, line {statement.line}: refers to vertex {quoted(words[outside[0]])}"
            f"{'; ' if count else ', '}{expected}"
        )
    return numbers


def _number(statement: Statement, word: bytes, source: str) -> int:
    place = f"{source}, line {statement.line}"
    number = whole_number(word.partition(b"/")[0], "the number of a vertex", place)
    # No file holds so many, and the least would not fit an array of numbers.
    return max(min(number, 2**40), -(2**40))


class Labels(NamedTuple):
    """The object and the groups that hold at a statement."""

    name: str
    groups: str


def labeled(statements: Iterable[Statement]) -> Iterator[tuple[Statement, Labels]]:
    """Each statement but ``o`` and ``g``, with what these say."""
    labels = Labels("", "")
    for statement in statements:
        if statement.keyword in ("o", "g"):
            text = decoded(b" ".join(statement.words))
            labels = (
                Labels(text, labels.groups)
                if statement.keyword == "o"
                else Labels(labels.name, text)
            )
        else:
            yield statement, labels
