"""Valid files, and copies of them that are damaged at random."""

import warnings
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from helpers.files.format_atlases import body_like, read, write
from helpers.surfaces.quad_grids import grid_mesh, hilly_net

from bodymeasure import Atlas, InputError
from bodymeasure.errors import ReadWarning

Random = np.random.Generator
# Words at which readers of numbers and of counts stumble.
WORDS = (
    b"nan inf -inf 1e999 -1e308 1e308 5e-324 0 -0 -1 1 2 3 4 999999999 4294967296 1_000 0x10 1. .5 "
    b"+ - # \\ / // 1/2/3 -1/-1 1e3 1d3 1,5 \xff \xc3\xa9 { } [ ] null true BBP BEZ224 BEZ614 end "
    b"surf parm deg cstype bezier bspline rat f v o g t crease trim call 3 3"
).split()


def valid_files() -> dict[str, tuple[str, bytes]]:
    """Small valid files by name, each with its format."""
    atlas = body_like(2, 2)
    weights = np.random.default_rng(1).uniform(0.5, 2.0, len(atlas.points))[atlas.index]
    rational = replace(atlas, weights=weights)
    files = {name: (name, write(atlas, name)) for name in ("atlas", "npz", "bpt", "bez", "geomdl")}
    files |= {
        f"rational {name}": (name, write(rational, name)) for name in ("bez", "obj", "geomdl")
    }
    files["obj"] = ("obj", write(atlas, "obj"))
    files["spline obj"] = ("obj", _spline())
    files["mesh obj"] = ("obj", _mesh())
    return files


def _spline() -> bytes:
    points = hilly_net(6, 5).swapaxes(0, 1).reshape(-1, 3).tolist()
    lines = ["v " + " ".join(map(repr, point)) for point in points]
    numbers = " ".join(map(str, range(-30, 0)))
    lines += ["g a b", "o sheet", "cstype bspline", "deg 3 2", f"surf 0 1 0 \\\n 1 {numbers}"]
    lines += ["parm u 0 0 0 0 0.3 0.6 1 1 1 1", "parm v 0 0 0 0.5 0.5 1 1 1", "end"]
    return "\n".join(lines).encode()


def _mesh() -> bytes:
    mesh = grid_mesh(hilly_net(5, 5))
    lines = ["v " + " ".join(map(repr, point)) for point in mesh.vertices.tolist()]
    lines += ["f " + " ".join(f"{k + 1}/1/1" for k in quad) for quad in mesh.quads.tolist()]
    lines += ["t crease 2/1/0 6 7 10", "g top", "f 25 24 26", "v 3 3 3"]
    return "\n".join(lines).encode()


def mutated(content: bytes, rng: Random) -> bytes:
    """The content with one change, or a few."""
    for _ in range(rng.geometric(0.7)):
        content = _CHANGES[rng.integers(len(_CHANGES))](content, rng)
    return content


def _byte(content: bytes, rng: Random) -> bytes:
    place = rng.integers(len(content) + 1)
    return content[:place] + bytes([rng.integers(256)]) + content[place + 1 :]


def _drop(content: bytes, rng: Random) -> bytes:
    place, length = rng.integers(len(content) + 1), int(10.0 ** rng.uniform(0.0, 2.5))
    return content[:place] + content[place + length :]


def _double(content: bytes, rng: Random) -> bytes:
    place, length = rng.integers(len(content) + 1), int(10.0 ** rng.uniform(0.0, 2.5))
    return content[: place + length] + content[place:]


def _cut(content: bytes, rng: Random) -> bytes:
    return content[: rng.integers(len(content) + 1)]


def _word(content: bytes, rng: Random) -> bytes:
    words = content.split(b" ")
    words[rng.integers(len(words))] = WORDS[rng.integers(len(WORDS))]
    return b" ".join(words)


def _insert(content: bytes, rng: Random) -> bytes:
    words = content.split(b" ")
    words.insert(rng.integers(len(words) + 1), WORDS[rng.integers(len(WORDS))])
    return b" ".join(words)


def _number(content: bytes, rng: Random) -> bytes:
    """Replace a digit, sign or point by another one, or by an exponent."""
    places = [k for k, sign in enumerate(content) if sign in b"0123456789.-"]
    if not places:
        return content
    place = places[rng.integers(len(places))]
    return (
        content[:place] + b"0123456789.-e"[(k := rng.integers(13)) : k + 1] + content[place + 1 :]
    )


def _line(content: bytes, rng: Random) -> bytes:
    """Leave out a line, double it, or swap it with another."""
    lines = content.split(b"\n")
    first, second = rng.integers(len(lines), size=2)
    what = rng.integers(3)
    if what == 0:
        del lines[first]
    elif what == 1:
        lines.insert(second, lines[first])
    else:
        lines[first], lines[second] = lines[second], lines[first]
    return b"\n".join(lines)


_CHANGES: tuple[Callable[[bytes, Random], bytes], ...] = (
    _byte,
    _drop,
    _double,
    _cut,
    _word,
    _insert,
    _number,
    _line,
)


def read_or_refused(content: bytes, form: str) -> Atlas | None:
    """The atlas, or None if the file is refused as it should be.

    Raises
    ------
    AssertionError
        If the atlas holds a number that is not finite, or more patches than the file can hold, or
        if the error does not name the file.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ReadWarning)
            atlas = read(content, form)
    except InputError as error:
        message = str(error)
        if not message.startswith("file"):
            raise AssertionError(f"which file? {message}") from error
        return None
    assert np.isfinite(atlas.control_points).all()
    # Every patch takes several bytes; the shortest form is a triangle given by its corners.
    assert len(atlas) <= len(content)
    return atlas
