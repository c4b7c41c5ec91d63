"""Holding numerical libraries to one thread, and checking that they keep to it."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass
class Threads:
    """The use of threads, complete at the end of `one_thread`.

    Parameters
    ----------
    limit : int
        The largest number of threads that any pool of a numerical library may use.
    pools : tuple of str
        Names of these libraries, for BLAS and OpenMP.
    processor_seconds : float
        Processor time of the whole process.
    other_threads : float
        The part of this time that threads other than the calling one took.
    """

    limit: int = 0
    pools: tuple[str, ...] = ()
    processor_seconds: float = 0.0
    other_threads: float = 0.0


@contextmanager
def one_thread() -> Iterator[Threads]:
    """Hold BLAS and OpenMP to one thread.

    Environment variables for the number of threads count only if they are set before NumPy is
    loaded, so the libraries are set directly. Threads of libraries that ignore this, or are loaded
    later, appear in the result; their time is part of all processor times in any case.
    """
    # The libraries are loaded first, so that their pools exist.
    import scipy.linalg  # noqa: F401
    from threadpoolctl import threadpool_info, threadpool_limits

    found = Threads()
    with threadpool_limits(limits=1):
        process, thread = time.process_time(), time.thread_time()
        try:
            yield found
        finally:
            process, thread = time.process_time() - process, time.thread_time() - thread
            pools = threadpool_info()
            found.limit = max((pool["num_threads"] for pool in pools), default=1)
            found.pools = tuple(sorted({pool["internal_api"] for pool in pools}))
            found.processor_seconds = process
            found.other_threads = max(0.0, process - thread) / process if process else 0.0
