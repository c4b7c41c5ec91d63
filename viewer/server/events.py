"""The streams by which pages hear what they did not ask for."""

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Any

from msgspec import json

# Seconds between signs of life, and events that may wait for a slow page.
TICK = 3.0
MOST_WAITING = 100


class Events:
    """All streams that are open.

    Parameters
    ----------
    hello : callable
        Returns what a page is told first.

    Attributes
    ----------
    closing : asyncio.Event
        Set when the server ends, which ends all streams.
    """

    def __init__(self, hello: Callable[[], dict[str, Any]] = dict) -> None:
        self._hello = hello
        self.closing = asyncio.Event()
        self._streams: set[asyncio.Queue[dict[str, Any]]] = set()

    def __len__(self) -> int:
        return len(self._streams)

    def tell(self, event: dict[str, Any]) -> None:
        """Tell all pages; one that does not listen misses it."""
        for stream in self._streams:
            if not stream.full():
                stream.put_nowait(event)

    async def listen(self) -> AsyncIterator[bytes]:
        """Yield the events as lines of JSON, and a sign of life every few seconds."""
        stream: asyncio.Queue[dict[str, Any]] = asyncio.Queue(MOST_WAITING)
        self._streams.add(stream)
        number = 0
        try:
            yield _line({"tick": number, **self._hello()})
            while not self.closing.is_set():
                event = asyncio.ensure_future(stream.get())
                closing = asyncio.ensure_future(self.closing.wait())
                try:
                    done, _ = await asyncio.wait(
                        {event, closing}, timeout=TICK, return_when=asyncio.FIRST_COMPLETED
                    )
                finally:
                    # A page that closes ends the stream here, and nothing may wait on.
                    event.cancel()
                    closing.cancel()
                if event in done:
                    yield _line(event.result())
                elif not done:
                    number += 1
                    yield _line({"tick": number})
        finally:
            self._streams.discard(stream)


def _line(event: dict[str, Any]) -> bytes:
    return json.encode(event) + b"\n"
