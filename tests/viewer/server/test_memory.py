"""A viewer that is open for long holds no more than at first."""

import time
from contextlib import ExitStack

import httpx
import numpy as np
import psutil
import pytest
from helpers.viewer_server import PATIENCE, POSIX, viewer

from bodymeasure.samples import sample_path

# Bytes by which memory may grow while it should not: the hardest of many paths needs more than the
# others, of which allocators keep some.
SLACK = 24 * 2**20
# Python starts a thread when none is idle at that very moment, and lets it go when it likes, so
# that counts of threads and of what they hold open differ by a few from run to run. Tabs that each
# left one behind would be told from that by their number.
TABS, CHANCE = 30, 10


@pytest.mark.slow
def test_memory_is_flat_over_100_tapes(rng: np.random.Generator) -> None:
    with viewer("female_average") as server:
        processes = [psutil.Process(server.process.pid), *server.workers()]

        def tapes(count: int) -> None:
            for number in range(count):
                ends = [[int(rng.integers(376)), *rng.random(2).tolist()] for _ in range(2)]
                asked = {"tab": "a", "serial": number, "locations": ends}
                assert server.post("/api/path", json=asked).status_code == 200

        tapes(60)
        before = [process.memory_info().rss for process in processes]
        tapes(100)
        after = [process.memory_info().rss for process in processes]
        assert all(b - a < SLACK for a, b in zip(before, after, strict=True)), (before, after)


@pytest.mark.slow
def test_memory_is_flat_over_bodies_that_are_opened() -> None:
    content = sample_path("male_average").read_bytes()
    with viewer("female_average") as server:

        def opened(count: int) -> None:
            for _ in range(count):
                headers = {"X-Name": "man.atlas"}
                found = server.post("/api/open", content=content, headers=headers).json()
                assert server.get(f"/api/body?body={found['id']}").status_code == 200

        opened(20)
        processes = [psutil.Process(server.process.pid), *server.workers()]
        before = [process.memory_info().rss for process in processes]
        opened(30)
        after = [process.memory_info().rss for process in processes]
        assert all(b - a < SLACK for a, b in zip(before, after, strict=True)), (before, after)


@pytest.mark.slow
@pytest.mark.skipif(not POSIX, reason="counts file descriptors")
def test_tabs_that_are_closed_leave_nothing() -> None:
    with viewer("paraboloid") as server:
        assert server.get("/api/body").status_code == 200
        process = psutil.Process(server.process.pid)

        def held() -> tuple[int, int]:
            return process.num_fds(), process.num_threads()

        def tabs(count: int) -> None:
            with ExitStack() as stack:
                for _ in range(count):
                    client = stack.enter_context(
                        httpx.Client(base_url=server.address, headers={"X-Token": server.token})
                    )
                    stream = stack.enter_context(client.stream("GET", "/api/events"))
                    assert next(stream.iter_lines()).startswith('{"tick":0')
                    ends = [[0, 0.1, 0.1], [0, 0.9, 0.9]]
                    asked = {"tab": str(id(client)), "locations": ends}
                    assert client.post("/api/path", json=asked).status_code == 200

        def more(before: tuple[int, int]) -> list[int]:
            return [now - then for now, then in zip(held(), before, strict=True)]

        tabs(5)
        before = held()
        tabs(TABS)
        # Connections that were closed are let go a moment later.
        patience = time.monotonic() + PATIENCE
        while max(more(before)) > CHANCE and time.monotonic() < patience:
            time.sleep(0.1)
        assert max(more(before)) <= CHANCE, (before, held())
