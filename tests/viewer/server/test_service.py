"""The state of the server outlives what happens to its workers and its file."""

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from bodymeasure.viewer.content.requests import (
    FindPoint,
    MeasureChart,
    OpenFile,
    ReadAgain,
    ShowBody,
    ShowLayer,
    Stop,
)
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from bodymeasure.viewer.server import service as module
from bodymeasure.viewer.server.events import Events
from bodymeasure.viewer.server.queue import GoneError, StoppedError
from bodymeasure.viewer.server.service import Service
from helpers.command_line import part_of_a_body

import bodymeasure as bm
from bodymeasure.samples import sample_path

PATIENCE = 180.0


def with_service(
    body: ShownBody, test: Callable[[Service], Awaitable[None]], others: Any = ()
) -> None:
    async def run() -> None:
        service = Service(body, others=others)
        service.begin()
        try:
            await test(service)
        finally:
            await service.end()

    asyncio.run(run())


@pytest.mark.slow
def test_a_file_is_watched_on_after_it_could_not_be_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "LOOK", 0.05)
    path = tmp_path / "body.atlas"
    bm.write_atlas(part_of_a_body(100, 106), path)
    body = ShownBody("0", bm.read_atlas(path), "Part", str(path), settings={})

    async def test(service: Service) -> None:
        heard: list[dict[str, Any]] = []
        arrived = asyncio.Event()

        def tell(event: dict[str, Any]) -> None:
            heard.append(event)
            arrived.set()

        monkeypatch.setattr(service.events, "tell", tell)
        queue = service._queues[False]
        ask, failures = queue.ask, [GoneError("it was killed")]

        async def failing(request: Any, **settings: Any) -> Any:
            if isinstance(request, ReadAgain) and failures:
                raise failures.pop()
            return await ask(request, **settings)

        monkeypatch.setattr(queue, "ask", failing)
        await service.answer(ShowBody())
        for count in (5, 4):
            bm.write_atlas(part_of_a_body(100, 100 + count), path)
            if count == 5:
                # The first time, nobody can read it.
                while failures:
                    await asyncio.sleep(0.05)
            else:
                await asyncio.wait_for(arrived.wait(), PATIENCE)
        assert heard == [{"changed": True}]
        assert len(service.bodies["0"].atlas) == 4

    with_service(body, test)


@pytest.mark.slow
def test_the_message_of_the_main_body_is_made_once() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")

    async def test(service: Service) -> None:
        first = await service.answer(ShowBody())
        assert await service.answer(ShowBody()) is first

    with_service(body, test)


@pytest.mark.slow
def test_a_chart_and_a_comparison_start_a_process_of_their_own() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")

    async def test(service: Service) -> None:
        await service.answer(FindPoint(location=(0, 0.5, 0.5)))
        assert service.workers[1].pid is None
        await service.answer(ShowLayer(name="diagonals"))
        assert service.workers[1].pid is None
        found = await service.answer(ShowLayer(name="diagonals", compare=True))
        assert found is not None
        assert found.kind == "binary"
        assert service.workers[1].pid is not None

    with_service(body, test)


def test_no_more_bodies_are_open_than_may_be() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")

    async def test(service: Service) -> None:
        assert list(service.bodies) == [str(number) for number in range(7)]

    with_service(body, test, [body] * 10)


@pytest.mark.slow
def test_a_page_that_is_loaded_again_knows_the_bodies_that_were_dropped() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")

    async def test(service: Service) -> None:
        await service.answer(ShowBody())
        content = sample_path("paraboloid").read_bytes()
        await service.answer(OpenFile(name="bowl.atlas", content=content))
        found = await service.answer(ShowBody())
        assert found is not None
        header, _ = unpacked(found.content)
        assert [one["name"] for one in header["bodies"]] == ["Part", "Paraboloid of revolution"]
        # And what connects anew is told what is open.
        assert list(service._hello()["bodies"]) == [one["id"] for one in header["bodies"]]

    with_service(body, test)


@pytest.mark.slow
def test_a_dropped_file_has_another_id_after_a_new_start() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")
    request = OpenFile(name="bowl.atlas", content=sample_path("paraboloid").read_bytes())
    ids = set[str]()

    async def test(service: Service) -> None:
        await service.answer(request)
        ids.update(service.bodies)

    for _ in range(2):
        with_service(body, test)
    assert len(ids - {"0"}) == 2


@pytest.mark.slow
def test_a_chart_is_stopped_by_the_tab_that_has_asked_and_by_no_other() -> None:
    body = ShownBody("0", bm.load_sample("female_average"), "Average")

    async def test(service: Service) -> None:
        told: list[dict[str, Any]] = []
        under_way = asyncio.Event()

        def tell(event: dict[str, Any]) -> None:
            told.append(event)
            under_way.set()

        service.events.tell = tell
        chart = asyncio.create_task(service.answer(MeasureChart(tab="mine")))
        waiting = asyncio.create_task(service.answer(MeasureChart(set="tops", tab="mine")))
        other = asyncio.create_task(service.answer(MeasureChart(set="core", tab="other")))
        await asyncio.wait_for(under_way.wait(), PATIENCE)
        found = await service.answer(Stop(tab="nobody"))
        assert found is not None
        assert (found.content, chart.done()) == (b'{"stopped":false}', False)
        found = await service.answer(Stop(tab="mine"))
        assert found is not None
        assert found.content == b'{"stopped":true}'
        for one in (chart, waiting):
            with pytest.raises(StoppedError, match="stopped before it was finished"):
                await asyncio.wait_for(one, PATIENCE)
        # The other tab's chart is measured, and nobody is told of a process that has died.
        answer = await asyncio.wait_for(other, PATIENCE)
        assert answer is not None
        assert answer.kind == "binary"
        assert not [one for one in told if "worker" in one]

    with_service(body, test)


def test_a_page_that_closes_leaves_no_task() -> None:
    async def test() -> None:
        # Alone, since the tasks of a whole service come and go.
        events, before = Events(), asyncio.all_tasks()

        async def listen() -> None:
            async for _line in events.listen():
                pass

        pages = [asyncio.create_task(listen()) for _ in range(5)]
        while len(events) < 5:
            await asyncio.sleep(0)
        await asyncio.sleep(0.05)
        assert len(asyncio.all_tasks() - before) > 5
        for page in pages:
            page.cancel()
        await asyncio.wait(pages)
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        assert asyncio.all_tasks() == before
        assert len(events) == 0

    asyncio.run(test())
