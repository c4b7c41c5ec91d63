"""The survey in worker processes on this machine, which may die without loss."""

import multiprocessing
import signal
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess

from bodymeasure.errors import MissingExtraError
from bodymeasure.oracle.workers import (
    ONE_THREAD,
    WorkerError,
    deaf_to_interrupts,
    end_with_parent,
    environment,
)
from bodymeasure.surveys.engine.batches import TRIES, Answer, Batch, Work
from bodymeasure.surveys.records import Row

NOT_STARTED = (
    "the worker processes end before they begin: in a script of your own, guard the call with "
    "`if __name__ == '__main__':`, since workers import the script; processes=1 works without them"
)


@dataclass(eq=False)
class _Worker:
    """A process, the pipe to it, and the batch that it is at.

    Each has its own pipe, so that it is known which batch a process has died with.
    """

    process: SpawnProcess
    pipe: Connection
    batch: Batch | None = None
    has_begun: bool = False


class Pool:
    """Measures in worker processes.

    Parameters
    ----------
    processes : int
    """

    def __init__(self, processes: int) -> None:
        self.processes = processes

    def __call__(self, batches: Iterator[Batch], work: Work) -> Iterator[Answer]:
        """Yield the rows of each batch, in the order in which they are done.

        Raises
        ------
        WorkerError
            If no process can be started.
        """
        workers: list[_Worker] = []
        again: list[Batch] = []
        tries: dict[tuple[int, int, int], int] = {}
        failed_starts = 0
        try:
            workers += [_started(work) for _ in range(self.processes)]
            while True:
                for worker in workers:
                    if worker.batch is None and worker.has_begun:
                        _give(worker, again.pop() if again else next(batches, None))
                if not again and all(each.has_begun and each.batch is None for each in workers):
                    return
                for worker in _heard(workers):
                    try:
                        rows: list[Row] | Exception | None = worker.pipe.recv()
                    except (EOFError, OSError):
                        failed_starts += not worker.has_begun
                        if failed_starts >= TRIES * self.processes:
                            raise WorkerError(NOT_STARTED) from None
                        _end(worker)
                        workers[workers.index(worker)] = _started(work)
                        if worker.batch is not None:
                            yield from _tried(worker.batch, tries, again)
                        continue
                    if rows is None:
                        worker.has_begun = True
                    elif isinstance(rows, Exception):
                        raise rows
                    elif worker.batch is not None:
                        done, worker.batch = worker.batch, None
                        # It works on while this one is written.
                        _give(worker, again.pop() if again else next(batches, None))
                        yield Answer(done, rows)
        finally:
            for worker in workers:
                _end(worker)


def _tried(
    batch: Batch, tries: dict[tuple[int, int, int], int], again: list[Batch]
) -> Iterator[Answer]:
    """Have a batch tried again whose process died, its bodies one by one, or give it up."""
    key = (batch.number, batch.first, len(batch.bodies))
    tries[key] = tries.get(key, 0) + 1
    if tries[key] < TRIES:
        again.append(batch)
    elif len(batch.bodies) > 1:
        again += batch.apart()
    else:
        yield Answer(batch, batch.given_up())


def _give(worker: _Worker, batch: Batch | None) -> None:
    if batch is None:
        return
    worker.batch = batch
    try:
        worker.pipe.send(batch.bodies)
    except OSError:
        # It has died just now, which is heard when it is asked for its rows.
        return


def _heard(workers: list[_Worker]) -> list[_Worker]:
    """Wait for processes that have an answer, or have died."""
    busy = {worker.pipe: worker for worker in workers if worker.batch or not worker.has_begun}
    return [busy[pipe] for pipe in wait(list(busy)) if isinstance(pipe, Connection)]


def _started(work: Work) -> _Worker:
    # Fresh interpreters: a fork would copy the locks of threads as they stand.
    context = multiprocessing.get_context("spawn")
    mine, other = context.Pipe()
    process = context.Process(target=_measure, args=(other, work), daemon=True)
    with environment(ONE_THREAD), deaf_to_interrupts():
        process.start()
    # Only the process holds that end now, so that its death is heard.
    other.close()
    return _Worker(process, mine)


def _end(worker: _Worker) -> None:
    worker.process.kill()
    worker.process.join()
    worker.pipe.close()


def _measure(pipe: Connection, work: Work) -> None:
    """Answer one batch after another, in a process of its own."""
    # Ctrl-C reaches the whole process group; the parent alone decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=end_with_parent, daemon=True).start()
    pipe.send(None)
    while True:
        try:
            bodies = pipe.recv()
        except EOFError:
            return
        try:
            pipe.send(work.rows(bodies))
        except MissingExtraError as error:
            pipe.send(_SentMissingError(str(error)))


class _SentMissingError(MissingExtraError):
    """A MissingExtraError that has come through a pipe."""

    def __init__(self, words: str) -> None:
        ImportError.__init__(self, words)
