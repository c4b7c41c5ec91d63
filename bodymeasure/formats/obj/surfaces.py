"""Free-form surfaces in Wavefront OBJ files, ``.obj``: Bezier and B-spline.

`surf` statements of ``cstype bezier`` and ``bspline``, rational or not, with several patches and
knots are read. Objects name the patches, and groups are their regions. Curves, points, texture
coordinates, normals and materials are left out; what would change the shape, such as trimming
curves, is refused.
"""

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.formats.obj.statements import (
    Labels,
    ObjFile,
    Statement,
    labeled,
    parse,
    vertex_numbers,
)
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import (
    DegreeError,
    SplinePatches,
    clamped_knots,
    faces_of_surfaces,
    notes_of_refused,
    spline_patches,
)
from bodymeasure.formats.text import few_numbers, quoted, whole_number, written

# Elements with a body; curves are left out.
ELEMENTS = frozenset({"surf", "curv", "curv2"})
# Statements that belong to a surface's body and change its shape.
TRIMMING = frozenset({"trim", "hole", "scrv"})
# Statements that the format has replaced by others, and those that refer to other files.
REFUSED = frozenset({"bmat", "step", "bzp", "bsp", "cdc", "cdp", "res", "call", "csh"})


class _Surface(NamedTuple):
    """A `surf` statement, the settings that hold for it, and its parameters in u and v."""

    statement: Statement
    labels: Labels
    kind: str
    rational: bool
    degrees: tuple[int, int]
    parameters: dict[str, tuple[float, ...]]


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    return from_statements(parse(content, source), source)


def from_statements(file: ObjFile, source: str) -> ReadPatches:
    """The patches of a file that is parsed already."""
    nets: list[Array] = []
    weights: list[Array] = []
    names: list[str] = []
    groups: list[str] = []
    places: list[str] = []
    refused: list[str] = []
    corners: list[Array] = []
    without: dict[str, str] = {}
    for surface in _surfaces(file, source):
        place = f"line {surface.statement.line}"
        try:
            own = _patches(surface, file, source)
        except DegreeError as error:
            refused.append(f"{place}: {error}")
            without[place] = f"it is left out, since it {error}"
            continue
        except InputError as error:
            message = str(error)
            if not message.startswith(source):
                message = f"{source}, {place}: {message}"
            raise InputError(message) from None
        count = len(own.nets)
        nets += own.nets
        weights += own.weights
        corners.append(own.corners)
        names += [surface.labels.name] * count
        groups += [surface.labels.groups] * count
        places += [place] * count
    notes = (*file.notes, *notes_of_refused(refused, source, any_read=bool(nets)))
    faces = faces_of_surfaces(places, corners, without)
    return ReadPatches(nets, weights, names, groups, places, notes=notes, faces=faces)


def _surfaces(file: ObjFile, source: str) -> Iterator[_Surface]:
    """The surfaces in order, each when its body has ended."""
    kind, rational, degrees = "", False, (0, 0)
    body: Statement | None = None
    parameters: dict[str, tuple[float, ...]] = {}
    for statement, labels in labeled(file.statements()):
        keyword, words, line, _ = statement
        place = f"{source}, line {line}"
        if keyword in REFUSED:
            raise InputError(
                f"{place}: {keyword} is not read; expected Bezier or B-spline surfaces in this "
                "file itself (cstype, deg, surf, parm, end)"
            )
        if body is not None and keyword not in TRIMMING | {"parm", "end"}:
            raise InputError(
                f"{place}: {keyword} inside the {body.keyword} of line {body.line}; expected parm "
                "or end"
            )
        if keyword == "cstype":
            kind, rational = _kind(words, place)
        elif keyword == "deg":
            degrees = _degrees(words, place)
        elif keyword in ELEMENTS:
            body, parameters = statement, {}
        elif body is None:
            if keyword in TRIMMING | {"parm", "end"}:
                raise InputError(f"{place}: {keyword} without a surf before it")
        elif keyword in TRIMMING:
            raise InputError(
                f"{place}: {keyword} trims the surface of line {body.line}; only whole surfaces "
                f"can be read; take out the {keyword} statement to have it untrimmed"
            )
        elif keyword == "parm":
            direction = words[0].decode("ascii", "replace") if words else ""
            if direction not in ("u", "v") or direction in parameters:
                raise InputError(f"{place}: expected parm u or parm v, once each, and its numbers")
            parameters[direction] = few_numbers(words[1:], place)
        elif keyword == "end":
            if body.keyword == "surf":
                yield _Surface(body, labels, kind, rational, degrees, parameters)
            body = None
    if body is not None:
        raise InputError(
            f"{source}, line {body.line}: the {body.keyword} has no end; the file may have been "
            "cut off"
        )


def _kind(words: list[bytes], place: str) -> tuple[str, bool]:
    rational = words[:1] == [b"rat"]
    kinds = words[1:] if rational else words
    if kinds not in ([b"bezier"], [b"bspline"]):
        raise InputError(
            f"{place}: cstype {quoted(b' '.join(words))} is not read; expected bezier or bspline, "
            "with or without rat"
        )
    return kinds[0].decode(), rational


def _degrees(words: list[bytes], place: str) -> tuple[int, int]:
    expected = "deg and one or two degrees of at least 1"
    if len(words) not in (1, 2):
        raise InputError(f"{place}: {len(words)} degrees; expected {expected}")
    numbers = [whole_number(word, expected, place) for word in words]
    if min(numbers) < 1:
        raise InputError(f"{place}: a degree of {min(numbers)}; expected {expected}")
    return numbers[0], numbers[-1]


def _patches(surface: _Surface, file: ObjFile, source: str) -> SplinePatches:
    """Return the patches of a surface."""
    statement, degrees = surface.statement, surface.degrees
    if not surface.kind or not degrees[0]:
        raise InputError("surf without cstype and deg before it")
    ranges = few_numbers(statement.words[:4], f"{source}, line {statement.line}")
    if len(ranges) != 4:
        raise InputError("expected surf, the ranges of u and v, and control points")
    numbers = vertex_numbers(statement, statement.words[4:], len(file.points), source)
    knots = _knots(surface, len(numbers))
    rows, columns = (len(k) - degree - 1 for k, degree in zip(knots, degrees, strict=True))
    if rows < 1 or columns < 1 or rows * columns != len(numbers):
        raise InputError(
            f"{len(numbers)} control points; expected {max(rows, 0)} x {max(columns, 0)}, which "
            "the parameters and degrees tell"
        )
    # u runs fastest in the file, and is the first axis of a net.
    numbers = numbers.reshape(columns, rows).T
    weights = file.weights[numbers] if surface.rational else _ones(numbers.shape)
    parts = (ranges[0], ranges[1]), (ranges[2], ranges[3])
    return spline_patches(file.points[numbers], weights, degrees, knots, parts)


@lru_cache(maxsize=64)
def _ones(shape: tuple[int, ...]) -> Array:
    weights = np.ones(shape)
    weights.flags.writeable = False
    return weights


def _knots(surface: _Surface, count: int) -> tuple[Array, Array]:
    """Knots in u and v; those of Bezier pieces are repeated as a B-spline has them."""
    result = []
    for direction, degree in zip("uv", surface.degrees, strict=True):
        given = surface.parameters.get(direction)
        if given is None:
            raise InputError(f"surf without parm {direction}")
        # A file cannot make a patch need more room than it has control points itself.
        if len(given) > count + degree + 1 or degree > count:
            raise InputError(
                f"{len(given)} parameters in {direction} at degree {degree} for {count} control "
                "points; expected fewer"
            )
        if surface.kind == "bezier":
            if len(given) < 2 or any(a >= b for a, b in pairwise(given)):
                raise InputError(
                    f"parm {direction} of a Bezier surface has {len(given)} numbers; expected at "
                    "least two, each larger than the last"
                )
            result.append(clamped_knots(degree, given))
        else:
            result.append(np.array(given))
    return result[0], result[1]


def write(atlas: Atlas) -> bytes:
    """An atlas as the content of a file: an object for each patch, a group for each region."""
    points, index = atlas.points, atlas.index
    if atlas.weights is not None:
        # Weights belong to a patch's control points, so that patches have their own.
        points = np.concatenate([points[index], atlas.weights[..., None]], axis=-1).reshape(-1, 4)
        index = np.arange(len(points)).reshape(index.shape)
    lines = ["# Bezier patches"]
    lines += [f"v {point}" for point in written(points)]
    lines += [
        f"cstype {'rat ' if atlas.is_rational else ''}bezier",
        f"deg {atlas.degree} {atlas.degree}",
    ]
    region = ""
    index = index.transpose(0, 2, 1).reshape(len(atlas), -1) + 1
    for name, group, numbers in zip(atlas.patch_names, atlas.regions, index.tolist(), strict=True):
        lines.append(f"o {_label(name, 'patch name')}")
        if group != region:
            lines.append(f"g {_label(group, 'region')}".rstrip())
            region = group
        lines += [
            "surf 0 1 0 1 " + " ".join(map(str, numbers)),
            "parm u 0 1",
            "parm v 0 1",
            "end",
        ]
    return ("\n".join(lines) + "\n").encode()


def _label(text: str, what: str) -> str:
    """A name as a statement can hold it."""
    try:
        encoded = text.encode()
    except UnicodeEncodeError:
        encoded = b"\\"
    words = encoded.split()
    if b" ".join(words) != encoded or encoded.endswith(b"\\"):
        raise InputError(
            f"the {what} {text!r} cannot be written to a Wavefront OBJ file; expected words with "
            "single spaces between, without a backslash after them; rename it"
        )
    return text
