"""Of a tab's tapes only the newest waits, and a request that fails does not stop the others."""

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from bodymeasure.viewer.server.queue import MOST_WAITING, BusyError, GoneError, Queue
from bodymeasure.viewer.server.work import Done
from bodymeasure.viewer.server.worker import WorkerGoneError

PATIENCE = 60.0


class Scripted:
    """A worker that answers when it is told to."""

    def __init__(self) -> None:
        self.asked: list[Any] = []
        self.fails: dict[Any, Exception] = {}
        self.free = asyncio.Event()
        self.lost: Callable[[], None] | None = None

    async def run(self, request: Any, _bodies: Any, **_settings: Any) -> Done:
        self.asked.append(request)
        await self.free.wait()
        if request in self.fails:
            raise self.fails[request]
        return Done(1, "json", str(request).encode())


def with_queue(test: Callable[[Queue, Scripted, list[str]], Awaitable[None]]) -> None:
    async def run() -> None:
        worker, told = Scripted(), list[str]()
        queue = Queue(worker, {}, lambda: told.append("restarted"))
        await asyncio.wait_for(test(queue, worker, told), PATIENCE)

    asyncio.run(run())


def asking(queue: Queue, request: Any, slot: Any = None) -> "asyncio.Task[Done | None]":
    return asyncio.create_task(queue.ask(request, limit=1.0, slot=slot))


async def settled() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


def contents(answers: list[Done | None]) -> list[bytes | None]:
    return [None if answer is None else answer.content for answer in answers]


def test_the_newest_of_a_tab_wins() -> None:
    async def test(queue: Queue, worker: Scripted, _told: list[str]) -> None:
        tasks = []
        for number in range(5):
            tasks.append(asking(queue, number, "tab"))
            await settled()
        worker.free.set()
        # The first was under way, and is finished; of the others, only the newest was asked for.
        assert contents(await asyncio.gather(*tasks)) == [b"0", None, None, None, b"4"]
        assert worker.asked == [0, 4]

    with_queue(test)


def test_tabs_do_not_overtake_one_another() -> None:
    async def test(queue: Queue, worker: Scripted, _told: list[str]) -> None:
        tasks = []
        for request, slot in (("a", None), ("b1", "b"), ("c1", "c"), ("b2", "b"), ("d", None)):
            tasks.append(asking(queue, request, slot))
            await settled()
        worker.free.set()
        assert contents(await asyncio.gather(*tasks)) == [b"a", None, b"c1", b"b2", b"d"]
        # A tab that drags keeps its place, so that it neither starves nor delays others.
        assert worker.asked == ["a", "b2", "c1", "d"]

    with_queue(test)


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (TimeoutError(), "this took longer than 1 s and was given up"),
        (WorkerGoneError(), "the process that measures ended unexpectedly"),
    ],
)
def test_a_request_that_the_worker_does_not_survive_is_told(error: Exception, words: str) -> None:
    async def test(queue: Queue, worker: Scripted, told: list[str]) -> None:
        worker.fails["bad"] = error
        worker.free.set()
        with pytest.raises(GoneError, match=words):
            await asking(queue, "bad")
        assert told == ["restarted"]
        answer = await asking(queue, "good")
        assert answer is not None
        assert answer.content == b"good"
        assert told == ["restarted"]

    with_queue(test)


def test_a_worker_that_dies_idle_is_told_of() -> None:
    async def test(_queue: Queue, worker: Scripted, told: list[str]) -> None:
        assert worker.lost is not None
        worker.lost()
        assert told == ["restarted"]

    with_queue(test)


def test_too_many_requests_are_refused() -> None:
    async def test(queue: Queue, worker: Scripted, _told: list[str]) -> None:
        tasks = [asking(queue, "under way")]
        await settled()
        tasks += [asking(queue, number) for number in range(MOST_WAITING)]
        await settled()
        with pytest.raises(BusyError):
            await asking(queue, "one more")
        worker.free.set()
        assert len(contents(await asyncio.gather(*tasks))) == MOST_WAITING + 1
        assert len(queue) == 0

    with_queue(test)


def test_who_has_gone_is_not_worked_for() -> None:
    async def test(queue: Queue, worker: Scripted, _told: list[str]) -> None:
        first, second = asking(queue, "first"), asking(queue, "second")
        await settled()
        second.cancel()
        await settled()
        worker.free.set()
        await first
        await asking(queue, "third")
        assert worker.asked == ["first", "third"]

    with_queue(test)


def test_all_that_wait_end_with_the_viewer() -> None:
    async def test(queue: Queue, _worker: Scripted, _told: list[str]) -> None:
        tasks = [asking(queue, number) for number in range(3)]
        await settled()
        queue.close()
        for task in tasks:
            with pytest.raises(GoneError, match="the viewer has ended"):
                await task
        with pytest.raises(GoneError, match="the viewer has ended"):
            await asking(queue, "too late")

    with_queue(test)
