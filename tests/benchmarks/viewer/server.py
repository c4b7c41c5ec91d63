"""What the server of the page costs: until the first body, a tape, and how long its loop is held.

    python tests/benchmarks/viewer/server.py

Times are processor time unless they say otherwise, so that other work on the machine counts little.
"""

import asyncio
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import psutil
import uvicorn
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.server.app import application
from bodymeasure.viewer.server.service import Service
from bodymeasure.viewer.server.worker import Worker

import bodymeasure as bm

TAPES = 100
PATIENCE = 120.0
TOKEN = "benchmark"
# Seconds between two looks at the event loop.
LOOK = 0.002


def processor_time(process: psutil.Process) -> float:
    """Return the processor time of a process and of all that it has started."""
    every = [process, *process.children(recursive=True)]
    return float(sum(sum(one.cpu_times()[:2]) for one in every))


def first_body() -> None:
    """Print the processor time from the command to the answer that holds the body."""
    times = []
    for _ in range(3):
        command = [sys.executable, "-m", "bodymeasure", "view", "--no-browser"]
        with subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        ) as process:
            assert process.stdout is not None
            address, _, token = process.stdout.readline().strip().partition("/#token=")
            headers = {"X-Token": token}
            found = httpx.get(f"{address}/api/body", headers=headers, timeout=PATIENCE)
            assert found.status_code == 200
            times.append(processor_time(psutil.Process(process.pid)))
            process.send_signal(signal.SIGINT)
    print(f"command to the first body: {np.median(times):.2f} s")


def worker_start() -> None:
    """Print the processor time that a worker takes until it can measure."""

    async def run() -> None:
        worker = Worker()
        bodies = {"0": ShownBody("0", bm.load_sample("female_average"), "Average")}
        begin = time.perf_counter()
        await worker.run(None, bodies, limit=PATIENCE)
        wall = time.perf_counter() - begin
        used = sum(psutil.Process(worker.pid).cpu_times()[:2])
        print(f"start of a worker, with its first tape: {used:.2f} s, wall {wall:.2f} s")
        worker.end()

    asyncio.run(run())


def ends(random: np.random.Generator, patches: int) -> list[list[float]]:
    """Return two random points."""
    return [[int(random.integers(patches)), random.random(), random.random()] for _ in range(2)]


def client(address: str, server: int, worker: int) -> None:
    """Ask for what pages ask for; print what each tape took."""
    random = np.random.default_rng(1)
    processes = [psutil.Process(number) for number in (server, worker)]

    def used() -> float:
        return float(sum(sum(process.cpu_times()[:2]) for process in processes))

    with httpx.Client(base_url=address, headers={"X-Token": TOKEN}, timeout=PATIENCE) as asked:
        times = []
        # The processor's clock ticks every 10 ms; several tapes are taken together.
        for _ in range(TAPES // 4):
            before = used()
            for _ in range(4):
                asked.post("/api/path", json={"locations": ends(random, 376)})
            times.append((used() - before) / 4)
        chart = threading.Thread(target=lambda: asked.post("/api/chart", json={}))
        chart.start()
        while chart.is_alive():
            asked.post("/api/path", json={"locations": ends(random, 376)})
            asked.get("/api/body")
            asked.get("/api/quantity?key=mean")
            asked.get("/api/layer?name=boundary")
        body = bm.load_sample("male_average")
        path = Path("/tmp") / f"bodymeasure-{os.getpid()}.atlas"
        bm.write_atlas(body, path)
        for _ in range(5):
            asked.post("/api/open", content=path.read_bytes(), headers={"X-Name": "man.atlas"})
        path.unlink()
    print(json.dumps({"tape": [float(np.median(times)), float(np.max(times))]}))


class _Loop:
    """Watches an event loop for how long it is held.

    Attributes
    ----------
    own, all_threads, late : list of float
        Between two looks: processor time of the loop's thread, that of all threads of the process
        (which may hold the interpreter lock), and how late the second look was: on a busy machine,
        that says more about the other programs.
    """

    def __init__(self) -> None:
        self.own: list[float] = []
        self.all_threads: list[float] = []
        self.late: list[float] = []

    async def watch(self) -> None:
        before = time.thread_time(), time.process_time(), time.perf_counter()
        while True:
            await asyncio.sleep(LOOK)
            now = time.thread_time(), time.process_time(), time.perf_counter()
            self.own.append(now[0] - before[0])
            self.all_threads.append(now[1] - before[1])
            self.late.append(now[2] - before[2] - LOOK)
            before = now


def event_loop() -> None:
    """Print how long the loop is held while a client asks, and what a tape takes."""
    service = Service(ShownBody("0", bm.load_sample("female_average"), "Average"))
    listener = socket.socket()
    listener.bind(("127.0.0.1", 0))
    port = listener.getsockname()[1]
    app = application(service, token=TOKEN, port=port)
    config = uvicorn.Config(app, http="h11", ws="none", lifespan="on", log_config=None)
    server, watched = uvicorn.Server(config), _Loop()

    async def run() -> None:
        serving = asyncio.create_task(server.serve([listener]))
        while not server.started:
            await asyncio.sleep(0.05)
        await service.answer(_body())
        watching = asyncio.create_task(watched.watch())
        pids = [str(os.getpid()), str(service.workers[0].pid)]
        command = [sys.executable, __file__, f"http://127.0.0.1:{port}", *pids]
        process = await asyncio.create_subprocess_exec(*command, stdout=subprocess.PIPE)
        out, _ = await process.communicate()
        watching.cancel()
        median, worst = json.loads(out)["tape"]
        print(f"a tape, server and worker together: median {median:.3f} s, worst {worst:.3f} s")
        server.should_exit = True
        await serving

    asyncio.run(run())
    for words, values in (
        ("its own processor time", watched.own),
        ("processor time of all threads", watched.all_threads),
        ("wall", watched.late),
    ):
        middle, high = np.percentile(values, [50, 99])
        print(
            f"event loop held, {words}: median {1e3 * middle:.1f} ms, 99 % {1e3 * high:.1f} ms, "
            f"worst {1e3 * max(values):.1f} ms"
        )


def _body() -> Any:
    from bodymeasure.viewer.content.requests import ShowBody

    return ShowBody()


PARTS: tuple[Callable[[], None], ...] = (first_body, worker_start, event_loop)

if __name__ == "__main__":
    if len(sys.argv) > 1:
        client(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
    else:
        for part in PARTS:
            part()
