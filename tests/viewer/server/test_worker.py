"""A worker process answers, and is replaced when it dies or takes too long."""

import asyncio
import os
import signal
from collections.abc import Awaitable, Callable

import psutil
import pytest
from bodymeasure.viewer.content.requests import FindPoint, MeasureChart
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.server.worker import Worker, WorkerGoneError
from msgspec import json

from bodymeasure import load_sample

LONG = 180.0


def with_worker(test: Callable[[Worker, dict[str, ShownBody]], Awaitable[None]]) -> None:
    """Run a test with a worker; afterwards, none of its processes is left."""
    bodies = {"0": ShownBody("0", load_sample("female_average"), "Average")}

    async def run() -> None:
        worker = Worker()
        try:
            await test(worker, bodies)
        finally:
            pid = worker.pid
            await asyncio.to_thread(worker.end)
            assert pid is None or not psutil.pid_exists(pid)

    asyncio.run(run())


async def point(worker: Worker, bodies: dict[str, ShownBody], body: str = "0") -> object:
    found = await worker.run(FindPoint(body=body, location=(0, 0.5, 0.5)), bodies, limit=LONG)
    return json.decode(found.content) if found.kind == "json" else found.content.decode()


def test_bodies_come_and_go_with_the_requests() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        first = await point(worker, bodies)
        bodies["1"] = ShownBody("1", load_sample("paraboloid"), "Bowl")
        assert await point(worker, bodies, "1") != first
        assert await point(worker, bodies) == first
        bodies["1"] = ShownBody("1", load_sample("enneper"), "Another", version=2)
        second = await point(worker, bodies, "1")
        assert isinstance(second, dict)
        assert second["name"] == bodies["1"].atlas.patch_names[0]
        del bodies["1"]
        assert await point(worker, bodies, "1") == (
            "no body is open as '1' any more; open its file again"
        )

    with_worker(test)


def test_a_body_that_is_read_again_while_its_old_form_is_measured_is_sent_later() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        bodies["1"] = ShownBody("1", load_sample("paraboloid"), "Bowl")
        under_way = asyncio.create_task(point(worker, bodies, "1"))
        while worker._waiting is None:
            await asyncio.sleep(0)
        bodies["1"] = ShownBody("1", load_sample("enneper"), "Another", version=2)
        bodies["2"] = ShownBody("2", load_sample("enneper"), "New")
        first = await under_way
        second = await point(worker, bodies, "1")
        assert isinstance(first, dict)
        assert isinstance(second, dict)
        assert second["name"] == bodies["1"].atlas.patch_names[0] != first["name"]
        assert await point(worker, bodies, "2") == second

    with_worker(test)


@pytest.mark.slow
def test_a_worker_that_was_killed_is_replaced() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        first = await point(worker, bodies)
        lost = asyncio.Event()
        worker.lost = lost.set
        assert worker.pid is not None
        os.kill(worker.pid, signal.SIGKILL)
        await asyncio.wait_for(lost.wait(), LONG)
        assert await point(worker, bodies) == first

    with_worker(test)


@pytest.mark.slow
def test_a_request_under_way_is_told_that_its_worker_died() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        begun = asyncio.Event()
        chart = asyncio.create_task(
            worker.run(MeasureChart(), bodies, limit=LONG, progress=lambda *_: begun.set())
        )
        await asyncio.wait_for(begun.wait(), LONG)
        assert worker.pid is not None
        os.kill(worker.pid, signal.SIGKILL)
        with pytest.raises(WorkerGoneError):
            await chart
        assert isinstance(await point(worker, bodies), dict)

    with_worker(test)


@pytest.mark.slow
def test_what_takes_too_long_is_ended_with_its_process() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        await point(worker, bodies)
        pid = worker.pid
        with pytest.raises(TimeoutError):
            await worker.run(MeasureChart(), bodies, limit=0.2)
        assert worker.pid is None
        assert pid is not None
        assert not psutil.pid_exists(pid)
        assert isinstance(await point(worker, bodies), dict)

    with_worker(test)


def test_an_error_of_the_library_is_a_sentence_and_any_other_a_traceback() -> None:
    async def test(worker: Worker, bodies: dict[str, ShownBody]) -> None:
        request = FindPoint(location=(999, 0.5, 0.5))
        found = await worker.run(request, bodies, limit=LONG)
        assert found.kind == "error"
        assert b"numbered 0 to 375" in found.content
        broken = dict(bodies)
        broken["0"] = "no body"
        with pytest.raises(AttributeError):
            await worker.run(request, broken, limit=LONG)

    with_worker(test)
