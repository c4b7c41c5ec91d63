"""Reading and writing whole files, with errors that a user can act on."""

import errno
import os
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from bodymeasure.errors import InputError


def read_bytes(path: Path) -> bytes:
    """Return a file's content.

    Raises
    ------
    InputError
        If there is no such file, or it cannot be read.
    """
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise InputError(f"{path}: no such file; check the path") from None
    except IsADirectoryError:
        raise InputError(f"{path}: is a directory; give the file inside it") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror or error})") from None


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file whole or not at all: a temporary file beside it is renamed.

    Raises
    ------
    InputError
        If the folder is missing or not writable, or the disk is full. Nothing is left behind.
    """
    with _user_errors(path):
        if _is_device(path):
            # Renaming would put a plain file in its place.
            path.write_bytes(content)
            return
    write_all({path: content})


def write_all(contents: Mapping[Path, bytes]) -> None:
    """Write files that belong together: each whole, and all of them or none.

    All content goes to temporary files first, so that a full disk or an interrupt changes nothing;
    then they are renamed, which needs no room. If a rename fails all the same, the files that this
    call added are removed; a file that is replaced already stays replaced.

    Parameters
    ----------
    contents : mapping of Path to bytes

    Raises
    ------
    InputError
        If a folder is missing or not writable, a path is a folder, or the disk is full.
    """
    temporaries: dict[Path, Path] = {}
    added: list[Path] = []
    try:
        for path, content in contents.items():
            with _user_errors(path):
                _write_temporary(path, content, temporaries)
        for path, temporary in temporaries.items():
            with _user_errors(path):
                is_new = not path.exists()
                temporary.replace(path.resolve())
            if is_new:
                added.append(path)
    except BaseException:
        for leftover in (*temporaries.values(), *added):
            leftover.unlink(missing_ok=True)
        raise


def _write_temporary(path: Path, content: bytes, temporaries: dict[Path, Path]) -> None:
    """Write content to a new file beside `path`, entered in `temporaries` before it is filled."""
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    # A link stays: the file that it points to is replaced.
    folder = path.resolve().parent
    descriptor, name = tempfile.mkstemp(prefix=".bodymeasure-", dir=folder)
    temporaries[path] = Path(name)
    with os.fdopen(descriptor, "wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
    Path(name).chmod(0o666 & ~_umask())


def make_folder(path: Path) -> None:
    """Make a folder and its parents, if they are not there.

    Raises
    ------
    InputError
        If it cannot be made or is a file.
    """
    _make_missing(path, [])


@contextmanager
def output_folder(path: Path) -> Iterator[None]:
    """Make a folder to write to, if it is not there, and prove it writable before the work.

    If the block fails or is interrupted, the folders that were made are removed again, unless there
    is something in them.

    Raises
    ------
    InputError
        If it cannot be made, is a file, or nothing can be written in it.
    """
    made: list[Path] = []
    try:
        _make_missing(path, made)
        with _user_errors(path):
            _try_writing(path)
        yield
    except BaseException:
        for folder in reversed(made):
            with suppress(OSError):
                folder.rmdir()
        raise


def require_writable(path: Path) -> None:
    """Refuse a file that could not be written, by trying to write beside it.

    Raises
    ------
    InputError
        If its folder is missing or not writable, or it is a folder itself.
    """
    with _user_errors(path):
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        if not _is_device(path):
            _try_writing(path.resolve().parent)


def _try_writing(folder: Path) -> None:
    # Permissions do not decide it: root has all, and a disk may be read-only.
    with tempfile.TemporaryFile(dir=folder):
        pass


def _is_device(path: Path) -> bool:
    """Return whether a path is a pipe or a device such as /dev/stdout."""
    return path.exists() and not (path.is_file() or path.is_dir())


def _make_missing(path: Path, made: list[Path]) -> None:
    """Make a folder and its parents; those that were not there are entered in `made`."""
    with _user_errors(path):
        if path.exists() and not path.is_dir():
            raise NotADirectoryError(errno.ENOTDIR, "it is a file, not a folder", str(path))
        for folder in reversed((path, *path.parents)):
            if not folder.exists():
                folder.mkdir(exist_ok=True)
                made.append(folder)


@contextmanager
def _user_errors(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise InputError(
            f"{path}: cannot be written ({error.strerror or error}); "
            "choose a folder that you may write to, on a disk with room"
        ) from None


def _umask() -> int:
    """The process's file mode mask, which can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
