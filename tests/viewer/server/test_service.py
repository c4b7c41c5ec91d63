"""The state of the server outlives what happens to its workers and its file."""

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from bodymeasure.viewer.content.requests import FindPoint, ReadAgain, ShowBody, ShowLayer
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.server import service as module
from bodymeasure.viewer.server.queue import GoneError
from bodymeasure.viewer.server.service import Service
from helpers.command_line import part_of_a_body

import bodymeasure as bm

PATIENCE = 60.0


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


def test_the_message_of_the_main_body_is_made_once() -> None:
    body = ShownBody("0", part_of_a_body(100, 106), "Part")

    async def test(service: Service) -> None:
        first = await service.answer(ShowBody())
        assert await service.answer(ShowBody()) is first

    with_service(body, test)


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
