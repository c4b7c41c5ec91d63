"""The requests that wait for a worker: in their order, and of each tab only the newest tape."""

import asyncio
import itertools
import logging
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from bodymeasure.viewer.server.work import Done
from bodymeasure.viewer.server.worker import Worker, WorkerGoneError

if TYPE_CHECKING:
    from bodymeasure.viewer.content.requests import Request
    from bodymeasure.viewer.content.shown import ShownBody

LOG = logging.getLogger("bodymeasure.viewer")
# Requests that may wait; of one tab there are a few at most.
MOST_WAITING = 200
ENDED = "the viewer has ended"
STOPPED = "this was stopped before it was finished"


class BusyError(Exception):
    """Too many requests wait."""


class StoppedError(Exception):
    """What is to be told of a request that was stopped by whoever had asked."""


class GoneError(Exception):
    """What is to be told of a request that the worker did not survive."""


@dataclass(eq=False)
class _Waiting:
    request: "Request | None"
    limit: float
    future: "asyncio.Future[Done | None]"
    progress: Callable[[int, int, str], None] | None
    stopped: bool = False


class Queue:
    """Requests for one worker.

    Parameters
    ----------
    worker : Worker
    bodies : mapping of str to ShownBody
        All that are open.
    restarted : callable
        Called when the worker died and is started again.
    """

    def __init__(
        self,
        worker: Worker,
        bodies: "Mapping[str, ShownBody]",
        restarted: Callable[[], None],
    ) -> None:
        self.worker = worker
        self._bodies = bodies
        self._restarted = restarted
        worker.lost = restarted
        self._waiting: dict[Hashable, _Waiting] = {}
        self._numbers = itertools.count()
        self._runner: asyncio.Task[None] | None = None
        self._current: _Waiting | None = None
        self._closed = False

    def __len__(self) -> int:
        return len(self._waiting)

    async def ask(
        self,
        request: "Request | None",
        *,
        limit: float,
        slot: Hashable = None,
        progress: Callable[[int, int, str], None] | None = None,
    ) -> Done | None:
        """Return the answer to a request, or None if a newer one has taken its slot.

        Parameters
        ----------
        request : Request or None
        limit : float
            The most seconds that its answer may take, once it is its turn.
        slot : hashable, optional
            Of the requests of one slot, only the newest waits. What is under way is finished.
        progress : callable, optional

        Raises
        ------
        BusyError
            If too many requests wait already.
        GoneError
            If it took too long, or the worker died of it.
        StoppedError
            If `stop` was called for its tab.
        """
        if self._closed:
            raise GoneError(ENDED)
        future: asyncio.Future[Done | None] = asyncio.get_running_loop().create_future()
        key = next(self._numbers) if slot is None else ("slot", slot)
        if key in self._waiting:
            older = self._waiting[key]
            if not older.future.done():
                older.future.set_result(None)
        elif len(self._waiting) >= MOST_WAITING:
            raise BusyError
        self._waiting[key] = _Waiting(request, limit, future, progress)
        if self._runner is None or self._runner.done():
            self._runner = asyncio.create_task(self._run())
        return await future

    async def _run(self) -> None:
        while self._waiting:
            waiting = self._waiting.pop(next(iter(self._waiting)))
            # Whoever asked may have gone.
            if waiting.future.done():
                continue
            self._current = waiting
            try:
                answer = await self.worker.run(
                    waiting.request,
                    self._bodies,
                    limit=waiting.limit,
                    progress=waiting.progress,
                )
            except TimeoutError:
                self._failed(
                    waiting,
                    f"this took longer than {waiting.limit:.0f} s and was given up; "
                    "measure to a point in between, or ask for less at once",
                )
            except WorkerGoneError:
                if waiting.stopped:
                    continue
                self._failed(
                    waiting,
                    "the process that measures ended unexpectedly (it was killed, or ran out of "
                    "memory) and is started again; try once more",
                )
            except Exception as error:
                LOG.exception("a request could not be passed on")
                if not waiting.future.done():
                    waiting.future.set_exception(error)
            else:
                if not waiting.future.done():
                    waiting.future.set_result(answer)

    def stop(self, tab: str) -> bool:
        """Stop what a tab has asked for; return whether there was anything."""
        asked = [
            waiting
            for waiting in (*self._waiting.values(), *([self._current] if self._current else []))
            if getattr(waiting.request, "tab", "") == tab and not waiting.future.done()
        ]
        for waiting in asked:
            waiting.stopped = True
            waiting.future.set_exception(StoppedError(STOPPED))
            if waiting is self._current:
                self.worker.stop()
        return bool(asked)

    def close(self) -> None:
        """Let all that wait end, and begin nothing any more.

        What the worker is at goes on until it is ended.
        """
        self._closed = True
        if self._runner is not None:
            self._runner.cancel()
        for waiting in (*self._waiting.values(), *([self._current] if self._current else [])):
            if not waiting.future.done():
                waiting.future.set_exception(GoneError(ENDED))
        self._waiting.clear()

    def _failed(self, waiting: _Waiting, words: str) -> None:
        LOG.error("%s: %s", type(waiting.request).__name__, words)
        if not waiting.future.done():
            waiting.future.set_exception(GoneError(words))
        self._restarted()
