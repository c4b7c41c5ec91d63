"""STL files in text: triangles of which each has its own three corners.

trimesh reads them too, but takes 2.4 KB a triangle, and passes over what it does not understand.
"""

import io

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.formats.text import Words

# A binary file has 80 bytes of any content, the number of triangles, and the triangles.
_HEADER, _COUNT_ENDS, _TRIANGLE = 80, 84, 50


def is_text(content: bytes) -> bool:
    """Return whether a file's content is STL in text.

    Binary files may begin with the word ``solid``, too, so that their length decides.
    """
    if len(content) >= _COUNT_ENDS and len(content) == binary_length(content):
        return False
    return content[:_HEADER].lstrip()[:5].lower() == b"solid" and b"\0" not in content


def binary_count(content: bytes) -> int:
    """Return the number of triangles that a binary file states."""
    return int.from_bytes(content[_HEADER:_COUNT_ENDS], "little")


def binary_length(content: bytes) -> int:
    """Return the number of bytes that a binary file has if it holds what it states."""
    return _COUNT_ENDS + _TRIANGLE * binary_count(content)


def read_text(content: bytes, source: str) -> Array:
    """Return the corners of all triangles, shape (3 m, 3).

    Raises
    ------
    InputError
        If a vertex is not made of three numbers, or a facet not of three vertices; the message has
        the line.
    """
    words = Words()
    corners, last = 0, b""
    for number, line in enumerate(io.BytesIO(content), 1):
        found = line.split()
        keyword = found[0].lower() if found else b""
        if keyword == b"vertex":
            if len(found) != 4:
                raise InputError(
                    f"{source}, line {number}: a vertex of {len(found) - 1} numbers; expected "
                    "vertex x y z"
                )
            words.add(number, found[1:])
            corners += 1
        elif keyword == b"endfacet":
            if corners != 3:
                raise InputError(
                    f"{source}, line {number}: ends a facet of {corners} vertices; expected three"
                )
            corners = 0
        elif keyword not in (b"facet", b"outer", b"endloop", b"solid", b"endsolid", b""):
            raise InputError(
                f"{source}, line {number}: begins with {keyword[:24].decode('utf-8', 'replace')!r}"
                "; expected a line of an STL file, as vertex x y z; export the file again"
            )
        last = keyword or last
    if last != b"endsolid":
        raise InputError(f"{source}: does not end with endsolid; it is cut off, export it again")
    return np.ascontiguousarray(words.numbers(source).reshape(-1, 3))
