"""Geomview's Bezier patches, ``.bez`` and ``.bbp``.

A header ``BBP`` (bicubic) or ``BEZuvn`` with the degrees u and v and n = 3 coordinates, or 4 with a
weight; then control points, u fastest, any number of patches. ``C`` in front means four corner
colors after each patch, ``ST`` or ``_ST`` four corner texture coordinates; both are left out here.
What follows ``#`` on a line is a remark. The format has neither a unit nor names; Geomview's
manual, section *Bezier Surfaces*, describes it.
"""

import re

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.bezier import homogeneous
from bodymeasure.errors import InputError
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.text import TextFile, Words, quoted, written

_HEADER = re.compile(
    rb"(?P<st>ST)?BBP|(?P<c>C)?BEZ(?P<u>[1-6])(?P<v>[1-6])(?P<n>[34])(?P<st2>_ST)?"
)
# The largest degree, which is written as one digit.
LARGEST = 6
_COLORS = 4 * 4
_TEXTURE = 4 * 2


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    file = TextFile.parse(content, source)
    lines = iter(file)
    line, (header, *rest) = next(lines)
    match = _HEADER.fullmatch(header)
    if match is None:
        raise InputError(
            f"{file.place(line)}: begins with {quoted(header)}; expected BBP or BEZ with two "
            "degrees and the number of coordinates, such as BEZ333, without braces, appearance or "
            "BINARY before it"
        )
    words = Words()
    words.add(line, rest)
    for each in lines:
        words.add(*each)
    values = words.numbers(source)
    rows, columns, coordinates = (int(match[name] or 3) + (name != "n") for name in "uvn")
    net = rows * columns * coordinates
    size = net + _TEXTURE * bool(match["st"] or match["st2"]) + _COLORS * bool(match["c"])
    if len(values) == 0 or len(values) % size:
        raise InputError(
            f"{file.place(words.lines[-1])}: the file ends after {len(values)} numbers; expected a "
            f"multiple of {size}, which is one patch of {quoted(header)}; it may have been cut off"
        )
    blocks = values.reshape(-1, size)[:, :net].reshape(-1, columns, rows, coordinates)
    # u runs fastest in the file, and is the first axis of a net.
    nets = blocks.transpose(0, 2, 1, 3)
    places = [f"line {words.line_of(number * size)}" for number in range(len(nets))]
    if coordinates == 3:
        return ReadPatches(list(nets), places=places)
    weights = nets[..., 3]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # Homogeneous: each point is given times its weight.
        points = nets[..., :3] / weights[..., None]
    return ReadPatches(list(points), weights=list(weights), places=places)


def write(atlas: Atlas) -> bytes:
    """An atlas as the content of a file.

    Raises
    ------
    InputError
        If its degree is above 6, for which there is no header.
    """
    if atlas.degree > LARGEST:
        raise InputError(
            f"an atlas of degree {atlas.degree} cannot be written to a Geomview file, whose header "
            f"goes up to {LARGEST}; choose .bpt or .obj"
        )
    coordinates = 4 if atlas.is_rational else 3
    header = (
        "BBP"
        if (atlas.degree, coordinates) == (3, 3)
        else f"BEZ{atlas.degree}{atlas.degree}{coordinates}"
    )
    nets = atlas.points[atlas.index]
    if atlas.weights is not None:
        nets = homogeneous(nets, atlas.weights)
    nets = nets.transpose(0, 2, 1, 3).reshape(len(atlas), -1, coordinates)
    return (header + "\n" + "".join("\n".join(written(net)) + "\n\n" for net in nets)).encode()
