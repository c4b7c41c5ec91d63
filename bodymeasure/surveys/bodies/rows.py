"""The rows of a large array in a file ``.npz``, a few at a time, so that memory stays small."""

import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any, Self

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.npz_arrays import MOST_EXPANSION

# The size in bytes up to which an array may expand more.
_SMALL = 1 << 20
DAMAGED = (
    zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, OSError,
    ValueError, TypeError, KeyError, SyntaxError, MemoryError,
)  # fmt: skip


class NpzFile:
    """A file of NumPy's format ``.npz``. Nothing is unpickled.

    Parameters
    ----------
    path : Path

    Raises
    ------
    InputError
        If it is missing, or no such file.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        if not path.is_file():
            raise InputError(f"{path}: no such file; check the path")
        with self._named():
            self.archive = zipfile.ZipFile(path)
            self.names = frozenset(
                info.filename.removesuffix(".npy") for info in self.archive.infolist()
            )

    def close(self) -> None:
        """Close the file."""
        self.archive.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @contextmanager
    def _named(self) -> Iterator[None]:
        try:
            yield
        except InputError:
            raise
        except DAMAGED as error:
            raise InputError(f"{self.path}: is no .npz file, or damaged ({error})") from None

    def small(self, name: str) -> NDArray[Any]:
        """Return an array that fits into memory.

        Raises
        ------
        InputError
            If it is damaged, or expands more than any such array does.
        """
        with self._named():
            info = self.archive.getinfo(f"{name}.npy")
            if info.file_size > MOST_EXPANSION * info.compress_size + _SMALL:
                raise InputError(
                    f"{self.path}: {name} says that it expands to {info.file_size} bytes, which is "
                    f"too much for {info.compress_size}; the file is damaged"
                )
            with self.archive.open(info) as file:
                read: NDArray[Any] = np.lib.format.read_array(file, allow_pickle=False)
                return read

    def rows(self, name: str) -> "Rows":
        """Return an array of floats, of which rows are read when they are asked for."""
        with self._named():
            return Rows(self, name)


class Rows:
    """An array of floats, shape (rows, ...), in a file.

    Parameters
    ----------
    file : NpzFile
    name : str
        Of the array.
    """

    def __init__(self, file: NpzFile, name: str) -> None:
        self._file, self._name = file, name
        with self._open() as (_, shape, dtype, begin):
            self.shape, self._dtype, self._begin = shape, dtype, begin
        size = file.archive.getinfo(f"{name}.npy").file_size
        if dtype.kind != "f" or not shape or min(shape) < 1:
            raise InputError(
                f"{file.path}: {name} is {dtype} of shape {shape}; expected floats, one row a body"
            )
        self._width = int(np.prod(shape[1:], dtype=np.int64)) * dtype.itemsize
        if begin + shape[0] * self._width != size:
            raise InputError(
                f"{file.path}: {name} has shape {shape}, which {size} bytes do not make; the file "
                "is damaged"
            )
        self._stream: IO[bytes] | None = None

    def __len__(self) -> int:
        return self.shape[0]

    @contextmanager
    def _open(self) -> Iterator[tuple[IO[bytes], tuple[int, ...], np.dtype[Any], int]]:
        with self._file.archive.open(f"{self._name}.npy") as stream:
            version = np.lib.format.read_magic(stream)
            read = {
                (1, 0): np.lib.format.read_array_header_1_0,
                (2, 0): np.lib.format.read_array_header_2_0,
            }.get(version)
            if read is None:
                raise InputError(
                    f"{self._file.path}: {self._name} has version {version} of NumPy's format; "
                    "expected 1 or 2"
                )
            shape, fortran, dtype = read(stream)
            if fortran and len(shape) > 1:
                raise InputError(
                    f"{self._file.path}: {self._name} is stored by columns; write it with "
                    "np.ascontiguousarray, so that bodies are read one by one"
                )
            yield stream, shape, dtype, stream.tell()

    def between(self, start: int, stop: int) -> Array:
        """Return some rows, as float64; going backward begins anew."""
        with self._file._named():
            if self._stream is None:
                self._stream = self._file.archive.open(f"{self._name}.npy")
            self._stream.seek(self._begin + start * self._width)
            content = self._stream.read((stop - start) * self._width)
        if len(content) < (stop - start) * self._width:
            raise InputError(f"{self._file.path}: {self._name} ends early; the file is damaged")
        rows = np.frombuffer(content, self._dtype).reshape(stop - start, *self.shape[1:])
        return rows.astype(np.float64)
