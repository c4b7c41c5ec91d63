"""One thread for the small matrices of this package.

A BLAS library wakes its threads for matrices of some hundred rows, whose products take less time
than the threads need to begin, and lets them wait in a loop for the next product. That costs up to
ten times the processor time of one thread, and several times the wall time where other processes
run beside it.
"""

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any


class _Limit:
    """The limit of some libraries to one thread, which calls may hold together.

    Attributes
    ----------
    holders : int
        The number of calls that hold it now.
    held : set of str
        The files of the libraries that it holds.
    before : list of (library, int)
        The libraries that had more threads, with their numbers.
    """

    def __init__(self) -> None:
        self.holders = 0
        self.held: set[str] = set()
        self.before: list[tuple[Any, int]] = []

    def enter(self, libraries: list[Any]) -> None:
        # SciPy's library may be loaded while that of NumPy is held.
        for library in libraries:
            if library.filepath in self.held:
                continue
            self.held.add(library.filepath)
            number = library.get_num_threads()
            if number is not None and number > 1 and _set(library, 1):
                self.before.append((library, number))
        self.holders += 1

    def leave(self) -> None:
        self.holders -= 1
        if self.holders == 0:
            for library, number in self.before:
                _set(library, number)
            self.held.clear()
            self.before.clear()


class _ThreadLimit(_Limit, threading.local):
    """A limit of each thread by itself."""


_LOCK = threading.Lock()
_OF_PROCESS, _OF_THREAD = _Limit(), _ThreadLimit()


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Hold the BLAS libraries to one thread, in a `with` statement or as a decorator.

    Most libraries have one number of threads for the whole process, so that other threads which
    call NumPy meanwhile are held to it too. The first call that enters sets the limit, and the last
    one that leaves puts back what was there before. Nothing is done where the user has limited the
    libraries to one thread. The first use takes some 4 milliseconds, each later one some 10
    microseconds, or one if it is within another.
    """
    with _LOCK:
        of_process, of_thread = _libraries()
        _OF_PROCESS.enter(of_process)
        _OF_THREAD.enter(of_thread)
    try:
        yield
    finally:
        with _LOCK:
            _OF_THREAD.leave()
            _OF_PROCESS.leave()


def _libraries() -> tuple[list[Any], list[Any]]:
    """The BLAS libraries with one number of threads for the process, and those with one a thread.

    They are looked for once, and again when SciPy's is loaded, which takes a tenth of a second and
    is not needed for much.
    """
    return _libraries_found("scipy.linalg" in sys.modules)


@cache
def _libraries_found(with_scipy: bool) -> tuple[list[Any], list[Any]]:  # noqa: ARG001
    from threadpoolctl import ThreadpoolController

    found = ThreadpoolController().select(user_api="blas").lib_controllers
    openmp = [getattr(library, "threading_layer", "") == "openmp" for library in found]
    parts: tuple[list[Any], list[Any]] = [], []
    for library, alone in zip(found, openmp, strict=True):
        parts[alone].append(library)
    return parts


def _set(library: Any, number: int) -> bool:
    """Set the number of threads of a library, and return whether it has that number now."""
    library.set_num_threads(number)
    # From 3.8 on, threadpoolctl ignores all threads but the first that set a number, until that one
    # lets others. The last call to leave may be on another thread.
    let_others = getattr(library, "clear_controlling_thread", None)
    if let_others is not None:
        let_others()
    return bool(library.get_num_threads() == number)
