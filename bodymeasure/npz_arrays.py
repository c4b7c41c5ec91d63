"""The arrays in a file of NumPy's format ``.npz`` from anywhere. Nothing is unpickled."""

import ast
import io
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import InputError

# The largest expansion: coordinates of bodies shrink to a third or so, and a file that expands more
# was made to fill the memory.
MOST_EXPANSION = 200
# The size in bytes up to which a file may expand more.
_SMALL = 1 << 20


def npz_arrays(
    content: bytes, source: str, kinds: Mapping[str, str], optional: frozenset[str] = frozenset()
) -> dict[str, NDArray[Any]]:
    """Return the arrays of a file, none of them larger than the file can hold.

    Parameters
    ----------
    content : bytes
    source : str
        Names the file in errors.
    kinds : mapping of str to str
        The names of the arrays, and the kinds of values of each, as NumPy codes them.
    optional : frozenset of str
        Those that the file may lack.

    Raises
    ------
    InputError
        If the file is no such archive, holds other arrays, or expands too much.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            sizes = {info.filename: info.file_size for info in archive.infolist()}
            there = {name for name in kinds if f"{name}.npy" in sizes}
            if len(there) != len(archive.infolist()) or not there >= kinds.keys() - optional:
                raise InputError(
                    f"{source}: holds {', '.join(sorted(sizes)) or 'nothing'}; expected the arrays "
                    f"{', '.join(kinds)}"
                )
            if sum(sizes.values()) > MOST_EXPANSION * len(content) + _SMALL:
                raise InputError(
                    f"{source}: says that it expands to {sum(sizes.values())} bytes, which is too "
                    f"much for a file of {len(content)}; it is damaged"
                )
            return {
                name: _array(archive.read(f"{name}.npy"), kinds[name], f"{source}, {name}")
                for name in kinds
                if name in there
            }
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
        OSError,
        ValueError,
    ) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{source}: is no .npz file, or damaged ({error})") from None


def _array(content: bytes, kinds: str, place: str) -> NDArray[Any]:
    """An array in NumPy's format, whose size is that of its bytes."""
    file = io.BytesIO(content)
    try:
        version = np.lib.format.read_magic(file)
        length = int.from_bytes(file.read(2 if version == (1, 0) else 4), "little")
        described = ast.literal_eval(file.read(length).decode("latin1"))
        shape, order = tuple(described["shape"]), described["fortran_order"]
        dtype = np.dtype(described["descr"])
        if dtype.kind not in kinds or dtype.hasobject:
            raise ValueError(f"holds {dtype}")
        data = content[file.tell() :]
        count = 1
        for size in shape:
            count *= size
        if count * dtype.itemsize != len(data) or min(shape, default=0) < 0:
            raise ValueError(f"has shape {shape}, which {len(data)} bytes do not make")
        return np.frombuffer(data, dtype).reshape(shape, order="F" if order else "C")
    except (ValueError, TypeError, KeyError, SyntaxError, MemoryError, RecursionError) as error:
        raise InputError(f"{place}: is no array ({error}); the file is damaged") from None
