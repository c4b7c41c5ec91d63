import math
import os
import signal
import subprocess
import sys
import textwrap

import pytest

from bodymeasure.oracle.workers import WorkerError, map_in_processes


@pytest.mark.parametrize("processes", [1, 2])
def test_results_come_in_order(processes: int) -> None:
    told: list[int] = []
    roots = map_in_processes(math.isqrt, range(10, 15), processes=processes, progress=told.append)
    assert roots == [math.isqrt(n) for n in range(10, 15)]
    assert told == [1, 2, 3, 4, 5]


@pytest.mark.slow
def test_errors_reach_the_caller() -> None:
    with pytest.raises(ValueError, match="nonnegative"):
        map_in_processes(math.isqrt, [4, -1], processes=2)


def test_a_dying_worker_is_reported() -> None:
    with pytest.raises(WorkerError, match="a worker process died"):
        map_in_processes(os._exit, [3, 3], processes=2)


def test_workers_run_one_thread_and_leave_the_environment() -> None:
    before = dict(os.environ)
    names = ["OMP_NUM_THREADS", "IGL_NUM_THREADS"]
    assert map_in_processes(os.getenv, names, processes=2) == ["1", "1"]
    assert dict(os.environ) == before


# The process sends itself the signal of Ctrl-C or `kill -9` after the first result, with work left.
INTERRUPTED = """
    import os, signal, time
    from bodymeasure.oracle.workers import map_in_processes

    def interrupt(finished):
        os.{send}, signal.{name})

    if __name__ == "__main__":
        # Children of a background process inherit that interrupts are ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            map_in_processes(time.sleep, [0.2] * 3000, processes=2, progress=interrupt)
        except KeyboardInterrupt:
            print("interrupted")
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="process groups")
@pytest.mark.parametrize(
    ("send", "name", "output"),
    [
        ("killpg(os.getpgrp()", "SIGINT", "interrupted\n"),
        ("kill(os.getpid()", "SIGKILL", ""),
    ],
    ids=["ctrl-c", "kill"],
)
def test_no_worker_outlives_its_parent(
    tmp_path_factory: pytest.TempPathFactory, send: str, name: str, output: str
) -> None:
    script = tmp_path_factory.mktemp("workers") / "script.py"
    script.write_text(textwrap.dedent(INTERRUPTED).format(send=send, name=name))
    process = subprocess.Popen(
        [sys.executable, str(script)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
    )
    try:
        # The workers hold the pipe's other end, which closes when the last of them has ended. If
        # nobody ended them, they would go on for minutes.
        assert process.communicate(timeout=120)[0] == output
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
