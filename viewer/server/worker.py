"""A worker process as the server sees it: started, asked, and replaced when it dies."""

import asyncio
import itertools
import logging
import multiprocessing
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import TYPE_CHECKING, Any

from bodymeasure.viewer.server.work import Done, Job, Progressed, work

from bodymeasure.oracle.workers import ONE_THREAD, deaf_to_interrupts, environment

if TYPE_CHECKING:
    from bodymeasure.viewer.content.requests import Request
    from bodymeasure.viewer.content.shown import ShownBody

    from bodymeasure.chart import Definitions

LOG = logging.getLogger("bodymeasure.viewer")
# What glibc otherwise keeps of large arrays after a long search: 20 MB and more. Others ignore it.
RETURN_MEMORY = {"MALLOC_MMAP_THRESHOLD_": "1048576", "MALLOC_TRIM_THRESHOLD_": "2097152"}


class WorkerGoneError(Exception):
    """The worker died before it had answered."""


class Worker:
    """A process that answers one request at a time.

    Parameters
    ----------
    own : Definitions, optional
        A set of definitions that the user has given.

    Attributes
    ----------
    lost : callable or None
        Called when the process died while it had nothing to do.
    """

    def __init__(self, own: "Definitions | None" = None) -> None:
        self.own = own
        self.lost: Callable[[], None] | None = None
        self._lock, self._ended = threading.Lock(), False
        self._process: BaseProcess | None = None
        self._connection: Connection | None = None
        self._known: dict[str, int] = {}
        self._numbers = itertools.count(1)
        self._waiting: tuple[int, asyncio.Future[Done], Callable[..., None] | None] | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    @property
    def pid(self) -> int | None:
        """The number of the process; None if none runs."""
        return None if self._process is None else self._process.pid

    def begin(self) -> None:
        """Start the process, unless it runs. It is ready for jobs before it has imported all."""
        with self._lock:
            if self._ended:
                raise WorkerGoneError
            # A process whose end of the connection is closed is as good as dead.
            if self._connection is None:
                self._kill()
                self._begin()

    def _begin(self) -> None:
        # Fresh interpreters: a fork would copy the locks of other threads as they stand.
        context = multiprocessing.get_context("spawn")
        here, there = context.Pipe()
        process = context.Process(target=work, args=(there,), daemon=True)
        with environment({**ONE_THREAD, **RETURN_MEMORY}), deaf_to_interrupts():
            process.start()
        # Only the worker holds its end, so that this one sees when it dies.
        there.close()
        self._process, self._connection, self._known = process, here, {}
        threading.Thread(target=self._listen, args=(here,), daemon=True).start()

    def end(self, *, for_good: bool = False) -> None:
        """End the process, whatever it is at; `for_good`, none is begun any more."""
        with self._lock:
            self._ended = self._ended or for_good
            self._kill()

    def _kill(self) -> None:
        process, self._process, self._connection = self._process, None, None
        if process is not None:
            # The thread that listens sees its end, and closes the connection.
            process.kill()
            process.join()
            process.close()

    async def run(
        self,
        request: "Request | None",
        bodies: "Mapping[str, ShownBody]",
        *,
        limit: float,
        progress: Callable[[int, int, str], None] | None = None,
    ) -> Done:
        """Return the answer to a request.

        Parameters
        ----------
        request : Request or None
            None makes the worker ready.
        bodies : mapping of str to ShownBody
            All that are open.
        limit : float
            The most seconds it may take.
        progress : callable, optional

        Raises
        ------
        WorkerGoneError
            If the process died.
        TimeoutError
            If it took longer; the process is ended.
        """
        self._loop = asyncio.get_running_loop()
        await asyncio.to_thread(self.begin)
        put = tuple(body for body in bodies.values() if self._known.get(body.id) != body.version)
        # Others may come, and be read again, while this is answered; it knows those of now.
        known = {body.id: body.version for body in bodies.values()}
        job = Job(next(self._numbers), request, put, tuple(known), self.own)
        future: asyncio.Future[Done] = self._loop.create_future()
        self._waiting = (job.number, future, progress)
        try:
            # The pipe may be full, and then waits for the worker.
            await asyncio.to_thread(self._send, job)
            answer = await asyncio.wait_for(future, limit)
        except (TimeoutError, WorkerGoneError):
            await asyncio.to_thread(self.end)
            raise
        finally:
            self._waiting = None
        self._known = known
        return answer

    def stop(self) -> None:
        """Give up what the process is at, as if it had died of it; for the event loop."""
        if self._waiting is not None and not self._waiting[1].done():
            self._waiting[1].set_exception(WorkerGoneError())

    def _send(self, job: Job) -> None:
        connection = self._connection
        if connection is None:
            raise WorkerGoneError
        try:
            connection.send(job)
        except (OSError, TypeError, ValueError):
            # The thread that listens may close the connection at any time.
            raise WorkerGoneError from None

    def _listen(self, connection: Connection) -> None:
        """Pass on what comes through a connection, in a thread of its own."""
        while True:
            try:
                message: Any = connection.recv()
            except (EOFError, OSError):
                break
            self._pass_on(self._arrived, message)
        with suppress(OSError):
            connection.close()
        self._pass_on(self._lost, connection)

    def _pass_on(self, function: Callable[[Any], None], content: Any) -> None:
        # The loop is closed when the server has ended.
        with suppress(RuntimeError):
            if self._loop is not None:
                self._loop.call_soon_threadsafe(function, content)

    def _arrived(self, message: Done | Progressed) -> None:
        if self._waiting is None or self._waiting[0] != message.number:
            return
        _, future, progress = self._waiting
        if isinstance(message, Progressed):
            if progress is not None:
                progress(message.done, message.total, message.words)
        elif not future.done():
            future.set_result(message)

    def _lost(self, connection: Connection) -> None:
        if connection is not self._connection:
            return
        self._connection = None
        if self._waiting is not None:
            if not self._waiting[1].done():
                self._waiting[1].set_exception(WorkerGoneError())
        elif self.lost is not None:
            self.lost()
