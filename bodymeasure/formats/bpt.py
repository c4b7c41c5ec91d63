"""BPT: the text format of the Utah teapot, ``.bpt``.

The first line has the number of patches. Each patch is a line with its two degrees, then a line
``x y z`` for each control point, u fastest. It has neither a unit nor names. What follows ``#`` is
a remark.
"""

import numpy as np

from bodymeasure.atlas import LARGEST_DEGREE, Atlas
from bodymeasure.errors import InputError
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import notes_of_refused
from bodymeasure.formats.text import TextFile, Words, whole_number, written

_Line = tuple[int, list[bytes]]


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    file = TextFile.parse(content, source)
    lines = iter(file)
    count = _count(next(lines), file)
    shapes: list[tuple[int, int]] = []
    places: list[str] = []
    words = Words()
    for number in range(count):
        line, (first, second) = _degrees(next(lines, None), number, file)
        for _ in range(first * second):
            words.add(*_point(next(lines, None), number, file))
        shapes.append((second, first))
        places.append(f"line {line}")
    extra = next(lines, None)
    if extra is not None:
        raise InputError(
            f"{file.place(extra[0])}: goes on after the last of {count} patches; expected the "
            "number of patches on the first line, and the degrees of each on a line"
        )
    points = words.numbers(source).reshape(-1, 3)
    ends = np.cumsum([first * second for first, second in shapes])
    blocks = zip(np.split(points, ends[:-1]), shapes, strict=True)
    # u runs fastest in the file, and is the first axis of a net.
    nets = [block.reshape(*shape, 3).transpose(1, 0, 2) for block, shape in blocks]
    refused = [
        f"{place}: patch {number} has the degrees {shape[1] - 1} and {shape[0] - 1}; only "
        f"degrees up to {LARGEST_DEGREE} can be read; reduce the degree where it was made"
        for number, (place, shape) in enumerate(zip(places, shapes, strict=True))
        if max(shape) - 1 > LARGEST_DEGREE
    ]
    kept = [number for number in range(count) if max(shapes[number]) - 1 <= LARGEST_DEGREE]
    notes = notes_of_refused(refused, source, any_read=bool(kept))
    return ReadPatches(
        [nets[number] for number in kept], places=[places[number] for number in kept], notes=notes
    )


def _count(header: _Line, file: TextFile) -> int:
    place, words = file.place(header[0]), header[1]
    expected = "the number of patches alone on the first line"
    if len(words) != 1:
        raise InputError(f"{place}: has {len(words)} words; expected {expected}")
    count = whole_number(words[0], expected, place)
    # The smallest patch has a line of degrees and four control points.
    most = (len(file.lines) - header[0]) // 5
    if not 1 <= count <= most:
        raise InputError(
            f"{place}: says {count} patches; expected at least 1, and no more than the {most} that "
            "the lines after it can hold"
        )
    return count


def _degrees(found: _Line | None, number: int, file: TextFile) -> tuple[int, tuple[int, int]]:
    """The line of a patch's degrees, and its control points along u and v."""
    line, words = _there(found, number, file)
    place, expected = file.place(line), f"the two degrees of patch {number}, such as 3 3"
    if len(words) != 2:
        raise InputError(f"{place}: has {len(words)} words; expected {expected}")
    first, second = (whole_number(word, expected, place) for word in words)
    if min(first, second) < 1:
        raise InputError(f"{place}: degrees {first} and {second}; expected {expected}, at least 1")
    return line, (first + 1, second + 1)


def _point(found: _Line | None, number: int, file: TextFile) -> _Line:
    line, words = _there(found, number, file)
    if len(words) != 3:
        raise InputError(
            f"{file.place(line)}: has {len(words)} words; expected x, y and z of a control point "
            f"of patch {number}"
        )
    return line, words


def _there(found: _Line | None, number: int, file: TextFile) -> _Line:
    if found is None:
        raise InputError(
            f"{file.source}: ends within patch {number}; the file may have been cut off, or its "
            "first line says too many patches"
        )
    return found


def write(atlas: Atlas) -> bytes:
    """An atlas as the content of a file.

    Raises
    ------
    InputError
        If it is rational, for which there is no room.
    """
    if atlas.is_rational:
        raise InputError(
            "a rational atlas cannot be written to a BPT file, which holds no weights; choose .bez "
            "or .obj"
        )
    nets = atlas.control_points.transpose(0, 2, 1, 3).reshape(len(atlas), -1, 3)
    lines = [str(len(atlas))]
    for net in nets:
        lines.append(f"{atlas.degree} {atlas.degree}")
        lines += written(net)
    return ("\n".join(lines) + "\n").encode()
