"""Work in several processes, since libigl holds the interpreter lock."""

import multiprocessing
import multiprocessing.resource_tracker
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import TypeVar

from bodymeasure.errors import BodymeasureError

Item = TypeVar("Item")
Result = TypeVar("Result")

# Each worker is one thread: more only get in each other's way. The libraries read these once, when
# they are loaded, so they have to be there when a worker starts.
ONE_THREAD = {
    "IGL_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}


class WorkerError(BodymeasureError, RuntimeError):
    """A worker process died before it had answered."""


def map_in_processes(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    *,
    processes: int,
    progress: Callable[[int], None] | None = None,
    apart: bool = False,
) -> list[Result]:
    """``[function(item) for item in items]``, in worker processes.

    Parameters
    ----------
    function : callable
        Importable by name: it is sent to fresh interpreters.
    items : sequence
        Each is sent on its own, and should take some tenths of a second.
    processes : int
        How many workers; 1 calls the function here.
    progress : callable, optional
        Called here with the number of finished items, each time one is finished.
    apart : bool
        Whether even a single worker is started, instead of calling the function here. Workers have
        one thread each; with more threads, sums may be rounded differently.

    Returns
    -------
    list
        In the order of the items.

    Raises
    ------
    WorkerError
        If a worker died.

    Notes
    -----
    Whatever is raised by the function, by `progress` or by Ctrl-C ends the workers before it
    reaches the caller; they also end on their own if this process is killed.
    """
    processes = min(processes, len(items))
    if processes < 1 or (processes == 1 and not apart):
        results = []
        for item in items:
            results.append(function(item))
            if progress is not None:
                progress(len(results))
        return results

    # Fresh interpreters: a fork would copy the locks of VTK's and BLAS's threads as they stand.
    context = multiprocessing.get_context("spawn")
    children = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(processes, mp_context=context, initializer=_start_worker)
    try:
        with environment(ONE_THREAD), deaf_to_interrupts():
            futures = [pool.submit(function, item) for item in items]
        _wait(futures, progress)
        return [future.result() for future in futures]
    except BrokenProcessPool as error:
        raise WorkerError(
            "a worker process died before it had answered: out of memory, killed, or crashed in "
            "libigl. In a script of your own, guard the call with "
            "`if __name__ == '__main__':`, since workers import the script; "
            "processes=1 works without workers and shows where it stops"
        ) from error
    except BaseException:
        # What they are at is of no use any more; without this, an interrupt would wait for it.
        for process in set(multiprocessing.active_children()) - children:
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def deaf_to_interrupts() -> Iterator[None]:
    """Start processes that Ctrl-C does not reach, from their first instruction on.

    They inherit the mask. An interrupt meanwhile is not lost: it comes at the end of the block.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # If the tracker were started later, that would clear the mask.
    multiprocessing.resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _wait(futures: list[Future[Result]], progress: Callable[[int], None] | None) -> None:
    for finished, future in enumerate(as_completed(futures), start=1):
        future.result()
        if progress is not None:
            progress(finished)


def _start_worker() -> None:
    # Ctrl-C reaches the whole process group; the parent alone decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=end_with_parent, daemon=True).start()


def end_with_parent() -> None:
    """Wait for the parent of this process to end, however it ends, and end this process then."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextmanager
def environment(variables: dict[str, str]) -> Iterator[None]:
    """Set variables for the processes that are started in the block."""
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
