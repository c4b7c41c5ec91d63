"""What the server knows: the bodies that are open, its workers, and who listens."""

import asyncio
import logging
import pickle
import secrets
from collections.abc import Callable, Hashable, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bodymeasure.viewer.content import requests
from bodymeasure.viewer.server.events import Events
from bodymeasure.viewer.server.queue import BusyError, GoneError, Queue
from bodymeasure.viewer.server.work import Done
from bodymeasure.viewer.server.worker import Worker
from msgspec import json

if TYPE_CHECKING:
    from bodymeasure.viewer.content.shown import ShownBody

    from bodymeasure.chart import Definitions

LOG = logging.getLogger("bodymeasure.viewer")
MAIN = "0"
# Bodies that may be open beside the first; those opened longest ago are closed.
MOST_OPENED = 6
# The most seconds of an answer for which somebody waits, and of a chart or a comparison.
LIMIT, LONG_LIMIT = 60.0, 1800.0
# Seconds between two looks at the file.
LOOK = 1.0


class Service:
    """The state of the server, which belongs to no tab.

    Parameters
    ----------
    body : ShownBody
    own : Definitions, optional
        A set of definitions that the user has given.
    others : sequence of ShownBody
        Bodies that are open beside it; no more than may be.
    """

    def __init__(
        self,
        body: "ShownBody",
        own: "Definitions | None" = None,
        others: "Sequence[ShownBody]" = (),
    ) -> None:
        self.bodies = {MAIN: replace(body, id=MAIN)}
        for number, other in enumerate(others[:MOST_OPENED], start=1):
            self.bodies[str(number)] = replace(other, id=str(number))
        # What takes long has a process of its own, so that tapes never wait for a chart; it is
        # started when it is first needed.
        self.workers = (Worker(own), Worker(own))
        self._loop: asyncio.AbstractEventLoop | None = None
        self._opened = len(self.bodies) - 1
        self._shown: tuple[tuple[int, *tuple[str, ...]], Done] | None = None
        # The main body's file as it was last read.
        self._read: tuple[int, int] | None = None

    def begin(self) -> None:
        """Begin, within the event loop."""
        self._loop = asyncio.get_running_loop()
        self.events = Events(self._hello)
        told = {"worker": "restarted"}
        self._queues = [
            Queue(worker, self.bodies, lambda: self.events.tell(told)) for worker in self.workers
        ]
        self._tasks = {asyncio.create_task(self._prepare()), asyncio.create_task(self._watch())}

    def close(self) -> None:
        """Let all that is open end, so that nobody waits for it; any thread may call this."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._close)

    def _close(self) -> None:
        self.events.closing.set()
        for task in self._tasks:
            task.cancel()
        for queue in self._queues:
            queue.close()

    async def end(self) -> None:
        """End all processes."""
        for task in self._tasks:
            task.cancel()
        for worker in self.workers:
            await asyncio.to_thread(worker.end, for_good=True)

    async def answer(self, request: requests.Request) -> Done | None:
        """Return the answer to a request; None if a newer one of the same tab took its place."""
        if isinstance(request, requests.ShowBody) and request.body == MAIN:
            return await self._body(request)
        if isinstance(request, requests.Stop):
            stopped = self._queues[True].stop(request.tab)
            return Done(0, "json", json.encode({"stopped": stopped}))
        charts = requests.MeasureChart | requests.MeasureOnMesh
        long = isinstance(request, charts) or self._compares(request)
        slot: Hashable = None
        if isinstance(request, requests.Ask) and request.tab:
            slot = (request.tab, type(request))
        found = await self._queues[long].ask(
            request,
            limit=LONG_LIMIT if long else LIMIT,
            slot=slot,
            progress=self._progress(request) if long else None,
        )
        if found is None:
            return None
        if isinstance(request, requests.OpenFile) and found.kind == "body":
            return self._open(found)
        if isinstance(request, requests.SaveLandmarks) and found.kind == "json":
            return await self._saved(request.body, found)
        return found

    async def _saved(self, name: str, found: Done) -> Done:
        """Return what is told of a file that was saved, once its body is the one of the file."""
        body = self.bodies.get(name)
        if body is None:
            return found
        stamp = await asyncio.to_thread(_stamp, Path(body.file))
        again = await self._queues[False].ask(requests.ReadAgain(body=name), limit=LIMIT)
        if again is None or again.kind != "body":
            return found if again is None else again
        self.bodies[name] = pickle.loads(again.content)
        if name == MAIN:
            # What is read already need not be found changed; other tabs are told of it here.
            self._read = stamp
            self.events.tell({"changed": True})
        return found

    async def _body(self, request: requests.ShowBody) -> Done | None:
        """Return the message of the main body, which all tabs get and which is made once."""
        # It names the bodies that are open beside it.
        about = (self.bodies[MAIN].version, *self.bodies)
        if self._shown is None or self._shown[0] != about:
            found = await self._queues[False].ask(request, limit=LIMIT)
            if found is None or found.kind != "binary":
                return found
            self._shown = (about, found)
        return self._shown[1]

    def _hello(self) -> dict[str, Any]:
        """Return what a page is told that connects: which bodies are open, and what they are."""
        return {"bodies": {name: body.mark for name, body in self.bodies.items()}}

    def _compares(self, request: requests.Request) -> bool:
        """Return whether a request is for a comparison that no report has made already."""
        if not isinstance(request, requests.ShowLayer) or not request.compare:
            return False
        body = self.bodies.get(request.body)
        return body is not None and body.differences is None

    def _progress(self, request: requests.Request) -> Callable[[int, int, str], None]:
        tab = getattr(request, "tab", "")

        def tell(done: int, total: int, words: str) -> None:
            event = {"tab": tab, "done": done, "total": total, "words": words}
            self.events.tell({"progress": event})

        return tell

    def _open(self, found: Done) -> Done:
        self._opened += 1
        # After a new start of the program, a page must not take another file for the one it has.
        name = f"{self._opened}-{secrets.token_hex(4)}"
        body = replace(pickle.loads(found.content), id=name)
        self.bodies[body.id] = body
        others = [name for name in self.bodies if name != MAIN]
        for name in others[:-MOST_OPENED]:
            del self.bodies[name]
        told = {"id": body.id, "name": body.name, "warnings": list(body.warnings)}
        return Done(found.number, "json", json.encode(told))

    async def _prepare(self) -> None:
        """Make ready what the first page asks for, and then the first tape."""
        # What cannot be made ready is told to whoever asks for it.
        with suppress(GoneError, BusyError):
            await self._body(requests.ShowBody())
            await self._queues[False].ask(None, limit=LIMIT)

    async def _watch(self) -> None:
        """Read the body's file again when it has changed, and tell the pages."""
        body = self.bodies[MAIN]
        if body.settings is None:
            return
        path = Path(body.file)
        seen = self._read = await asyncio.to_thread(_stamp, path)
        while True:
            await asyncio.sleep(LOOK)
            now = await asyncio.to_thread(_stamp, path)
            # A file that still grows, or is missing while another takes its place, waits.
            if now is not None and now == seen and now != self._read:
                try:
                    again = requests.ReadAgain(body=MAIN)
                    found = await self._queues[False].ask(again, limit=LIMIT)
                except (GoneError, BusyError) as error:
                    LOG.error("%s cannot be read again: %s", path, error)
                    found = None
                self._read = now
                if found is not None and found.kind == "body":
                    self.bodies[MAIN] = pickle.loads(found.content)
                    self.events.tell({"changed": True})
                elif found is not None and found.kind == "error":
                    self.events.tell({"error": found.content.decode()})
            seen = now


def _stamp(path: Path) -> tuple[int, int] | None:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
