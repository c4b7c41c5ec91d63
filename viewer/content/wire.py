"""The binary messages of the page: a header as JSON, and arrays behind it."""

from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

# Typed arrays in a browser begin at multiples of the size of their members.
ALIGNMENT = 4
# The members of arrays that a page reads, in the order of the bytes that all browsers have.
KINDS = {"f": "<f4", "u": "<u4", "i": "<u4", "b": "u1"}
NAMES = {"<f4": "float32", "<u4": "uint32", "u1": "uint8"}


def packed(header: Mapping[str, Any], arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Return a header and arrays as one message.

    Parameters
    ----------
    header : mapping of str to object
        What JSON can hold; numbers that are not finite become null.
    arrays : mapping of str to ndarray
        Floating-point numbers are sent with 32 bits, whole numbers without a sign likewise.

    Returns
    -------
    bytes
        The header's length (32 bits, little-endian), the header, padded with spaces to a multiple
        of 4 bytes, and the arrays, whose places behind it the header gives as ``arrays``.

    Examples
    --------
    >>> message = packed({"name": "a"}, {"heights": np.array([1.5, 2.0])})
    >>> unpacked(message)[1]["heights"].tolist()
    [1.5, 2.0]
    """
    places, parts, offset = {}, [], 0
    for name, array in arrays.items():
        code = "u1" if array.dtype == np.uint8 else KINDS[array.dtype.kind]
        content = np.ascontiguousarray(array, dtype=code).tobytes()
        places[name] = {"offset": offset, "shape": list(array.shape), "dtype": NAMES[code]}
        content += bytes(-len(content) % ALIGNMENT)
        parts.append(content)
        offset += len(content)
    text = msgspec.json.encode({**header, "arrays": places})
    text += b" " * (-len(text) % ALIGNMENT)
    return b"".join([len(text).to_bytes(4, "little"), text, *parts])


def unpacked(message: bytes) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Return the header and the arrays of a message that `packed` made."""
    start = 4 + int.from_bytes(message[:4], "little")
    header: dict[str, Any] = msgspec.json.decode(message[4:start])
    codes = {name: code for code, name in NAMES.items()}
    arrays = {}
    for name, place in header["arrays"].items():
        count = int(np.prod(place["shape"], dtype=np.int64))
        flat = np.frombuffer(message, codes[place["dtype"]], count, start + place["offset"])
        arrays[name] = flat.reshape(place["shape"])
    return header, arrays
