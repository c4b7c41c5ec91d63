"""Worker processes and Dask give the same file as this process, even where workers die."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from helpers.populations import Deadly, knees, write_shapes

import bodymeasure as bm
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.surveys.engine import Batch, Cluster, Here, Pool, Work, batch_size
from bodymeasure.surveys.engine.batches import DIED
from bodymeasure.surveys.engine.cluster import connected
from bodymeasure.surveys.folder.parts import FOLDER
from bodymeasure.surveys.records import Charting

pytest.importorskip("pyarrow")
BODIES = 12


def batches(*modes: str) -> Iterator[Batch]:
    """Batches of three bodies each."""
    bodies = [Deadly(f"body {place}", mode) for place, mode in enumerate(modes)]
    for number, first in enumerate(range(0, len(bodies), 3)):
        yield Batch(number, 0, tuple(bodies[first : first + 3]))


def work() -> Work:
    return Work.of(Charting(knees(), (), Unit.CM, despite_errors=False))


def reasons(engine: Any, *modes: str) -> dict[str, str]:
    answers = engine(batches(*modes), work())
    return {row.subject: row.failure for answer in answers for row in answer.rows}


def test_batches_become_neither_too_many_nor_too_large() -> None:
    assert [batch_size(count) for count in (1, 40, 2000, 10**6)] == [1, 1, 4, 64]


def test_a_missing_package_ends_the_survey() -> None:
    with pytest.raises(MissingExtraError, match="needs the package 'nothing'"):
        reasons(Here(), "", "lacks")


@pytest.mark.slow
def test_processes_give_the_same_file(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", BODIES)
    tables = [
        bm.survey(path, knees(), folder=tmp_path / str(number), processes=number)
        for number in (1, 2)
    ]
    assert tables[0].path.read_bytes() == tables[1].path.read_bytes()


@pytest.mark.slow
def test_a_body_that_ends_its_process_is_given_up_and_no_other() -> None:
    found = reasons(Pool(2), "", "", "", "", "dies", "", "", "")
    assert found == {f"body {place}": DIED if place == 4 else "" for place in range(8)}
    with pytest.raises(MissingExtraError, match="needs the package 'nothing'"):
        reasons(Pool(2), "", "lacks")


@pytest.mark.slow
def test_a_killed_worker_loses_nothing(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", BODIES)
    whole = bm.survey(path, knees(), folder=tmp_path / "whole")
    killed: list[int] = []

    def kill(done: int, total: int) -> None:
        if done and done < total and len(killed) < 2:
            worker = next(
                child
                for child in psutil.Process().children()
                if "spawn_main" in " ".join(child.cmdline()) and child.pid not in killed
            )
            worker.kill()
            killed.append(worker.pid)

    table = bm.survey(path, knees(), folder=tmp_path / "out", processes=2, progress=kill)
    assert len(killed) == 2
    assert table.path.read_bytes() == whole.path.read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize("processes", [1, 2])
def test_a_survey_that_is_killed_goes_on_and_gives_the_same_file(
    processes: int, tmp_path: Path
) -> None:
    path = write_shapes(tmp_path / "many.npz", 30)
    command = [sys.executable, "-m", "bodymeasure", "survey", str(path), "--only"]
    command += ["waist_girth,knee_height", "--processes", str(processes), "-o"]
    assert subprocess.run([*command, str(tmp_path / "whole")], check=False).returncode == 0
    parts = tmp_path / "out" / FOLDER
    running = subprocess.Popen([*command, str(tmp_path / "out")])
    try:
        while len(list(parts.glob("*/*.part"))) < 8:
            assert running.poll() is None, "it was done before it could be killed"
            time.sleep(0.01)
    finally:
        running.kill()
        running.wait()
    assert not (tmp_path / "out" / "survey.parquet").exists()
    assert 8 <= len(list(parts.glob("*/*.part"))) < 30
    assert subprocess.run([*command, str(tmp_path / "out")], check=False).returncode == 0
    names = sorted(file.name for file in (tmp_path / "whole").glob("*.*"))
    assert "survey.parquet" in names
    for name in names:
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()


@contextmanager
def local_cluster(workers: int) -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    # Dask closes its loops and sockets in its own time.
    with (
        distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster, set_as_default=False) as client,
    ):
        yield client


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_gives_the_same_file_even_if_a_worker_is_killed(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", BODIES)
    whole = bm.survey(path, knees(), folder=tmp_path / "whole")
    with local_cluster(2) as client:
        pids = client.run(os.getpid)
        killed: list[int] = []

        def kill(done: int, total: int) -> None:
            if done and done < total and not killed:
                killed.append(next(iter(pids.values())))
                psutil.Process(killed[0]).kill()

        table = bm.survey(path, knees(), folder=tmp_path / "a", client=client, progress=kill)
        assert killed
        assert table.path.read_bytes() == whole.path.read_bytes()
        address = client.scheduler.address
        command = [sys.executable, "-m", "bodymeasure", "survey", str(path), "--only"]
        command += ["knee_height", "--scheduler", address, "-o", str(tmp_path / "b")]
        assert subprocess.run(command, check=False).returncode == 0
    heights = bm.survey(path, folder=tmp_path / "c", only=["knee_height"])
    assert (tmp_path / "b" / "survey.parquet").read_bytes() == heights.path.read_bytes()


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_gives_up_a_body_that_ends_its_workers_and_no_other() -> None:
    with local_cluster(2) as client:
        client.run(sys.path.append, str(Path(__file__).parents[1]))
        found = reasons(Cluster(client), "", "", "", "", "dies", "")
    assert found == {f"body {place}": DIED if place == 4 else "" for place in range(6)}


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
def test_rows_that_die_with_their_worker_are_measured_again() -> None:
    with local_cluster(1) as client:
        client.run(sys.path.append, str(Path(__file__).parents[1]))

        def statuses() -> list[str]:
            return [future.status for future in client.futures.values()]

        def killing() -> Iterator[Batch]:
            first, second, third = batches(*[""] * 9)
            yield first
            yield second
            # The rows of the first are here by now, and those of the second with the worker.
            wait_until(lambda: set(statuses()) == {"finished"})
            (worker,) = client.run(os.getpid).values()
            os.kill(worker, signal.SIGKILL)
            wait_until(lambda: "finished" not in statuses() or "lost" in statuses())
            yield third

        answers = list(Cluster(client)(killing(), work()))
    assert sorted(answer.batch.number for answer in answers) == [0, 1, 2]
    assert all(not row.failure for answer in answers for row in answer.rows)


def wait_until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 30.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.mark.parametrize("address", ["nonsense", "tcp://host", "http://host:80"])
def test_what_is_no_address_is_refused(address: str) -> None:
    pytest.importorskip("distributed")
    refused = pytest.raises(InputError, match=f"'{address}' is no address of a scheduler")
    with refused, connected(address):
        pass


@pytest.mark.slow
def test_no_scheduler_at_an_address_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("bodymeasure.surveys.engine.cluster.TIMEOUT", 0.5)
    refused = pytest.raises(InputError, match="no scheduler answers there")
    with refused, connected("tcp://127.0.0.1:9"):
        pass


def test_workers_with_other_versions_are_refused() -> None:
    pytest.importorskip("distributed")

    class Other:
        def run(self, function: Any, *arguments: Any) -> dict[str, dict[str, str]]:
            return {"tcp://host:1": {**function(*arguments), "numpy": "0.1"}} if self.there else {}

        def run_on_scheduler(self, function: Any, *arguments: Any) -> Any:
            if not self.loads:
                raise RuntimeError("No module named 'bodymeasure'")
            return function(*arguments)

        there = loads = True

    client: Any = Other()
    with pytest.raises(
        InputError, match=r"the worker tcp://host:1 has numpy 0.1, and this process"
    ):
        reasons(Cluster(client), "")
    client.loads = False
    with pytest.raises(InputError, match="the scheduler or a worker cannot load bodymeasure"):
        reasons(Cluster(client), "")
    client.loads, client.there = True, False
    with pytest.raises(InputError, match="the scheduler has no worker"):
        reasons(Cluster(client), "")
