"""BLAS libraries use one thread while this package computes, and as many as before afterwards."""

import ast
import inspect
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Barrier

import numpy as np
import pytest
import scipy.linalg  # noqa: F401  # so that its library is found
from helpers.modules import all_modules
from threadpoolctl import threadpool_info, threadpool_limits

import bodymeasure as bm
from bodymeasure.threads import one_blas_thread

# They read and write files, or compute next to nothing.
WITHOUT = {
    *("homogeneous", "load_definitions", "load_pattern", "load_sample"),
    *("path_to_trimesh", "sample_names"),
    *("read_atlas", "read_measurements", "read_population", "read_survey", "read_topology"),
    *("write_atlas", "write_chart", "write_glb"),
    *("write_paths", "write_population", "write_report", "show"),
}
MANY = 3
# What a process does, and whether a thread of its libraries was awake meanwhile: while a thread
# sleeps, its state and the number of times it was switched to or from stay the same.
SCRIPT = """
import os, sys, threading, time
os.environ["OPENBLAS_NUM_THREADS"] = "4"
import numpy as np, scipy.linalg
import bodymeasure as bm

def threads():
    own = str(threading.get_native_id())
    return {
        thread: [
            line for line in open(f"/proc/self/task/{thread}/status")
            if line.startswith("State") or "ctxt" in line
        ]
        for thread in os.listdir("/proc/self/task") if thread != own
    }

def asleep():
    before = {}
    # A thread that waits for a busy processor is not switched to either, but runs on later.
    while before != (before := threads()) or any("S (" not in told[0] for told in before.values()):
        time.sleep(0.05)
    return before

large = np.ones((500, 500))
large @ large
before = asleep()
assert before, "there is one thread only"
%s
after = threads()
print("woken" if any(after[thread] != before[thread] for thread in before) else "asleep")
"""
# Newton's method with 144 unknowns, and searches with systems and products of every kind.
PATCHES = """
x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
heights = np.random.default_rng(3).uniform(-2, 2, (20, 4, 4))[%s]
for net in (np.stack([x, y, height], axis=-1) for height in heights):
    bm.solve_geodesic(net, (0, 0), (1, 1), on_failure="status")
"""
BODY = """
body = bm.load_sample("female_average")
bm.diagonals(body, search="thorough", on_failure="status")
bm.geodesic_between(body, "back neck point", "bust point left")
bm.check_atlas(body)
bm.boundary_lengths(body)
bm.measure_chart(body)
"""


def limits() -> set[int]:
    """Return the numbers of threads of all BLAS libraries."""
    return {pool["num_threads"] for pool in threadpool_info() if pool["user_api"] == "blas"}


@pytest.fixture(autouse=True)
def many() -> object:
    with threadpool_limits(limits=MANY, user_api="blas"):
        yield


def test_libraries_have_one_thread_within_and_the_old_number_afterwards() -> None:
    assert limits() == {MANY}
    with one_blas_thread():
        assert limits() == {1}
        with one_blas_thread():
            assert limits() == {1}
        assert limits() == {1}
    assert limits() == {MANY}


def test_an_error_leaves_the_old_number() -> None:
    @one_blas_thread()
    def fail() -> None:
        assert limits() == {1}
        raise ZeroDivisionError

    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            fail()
        assert limits() == {MANY}


def test_the_last_of_several_threads_puts_the_old_number_back() -> None:
    entered, left = Barrier(2, timeout=120.0), Barrier(2, timeout=120.0)

    def early() -> set[int]:
        with one_blas_thread():
            entered.wait()
        found = limits()
        left.wait()
        return found

    def late() -> set[int]:
        with one_blas_thread():
            entered.wait()
            left.wait()
            return limits()

    # This thread lets go of the number that the fixture has set.
    with one_blas_thread():
        pass
    with ThreadPoolExecutor(2) as pool:
        found = [task.result() for task in (pool.submit(early), pool.submit(late))]
    assert found == [{1}, {1}]
    assert limits() == {MANY}


def test_a_number_that_another_thread_insists_on_is_left_alone() -> None:
    # The fixture has set it on this thread, and has not let go.
    def compute() -> None:
        with one_blas_thread():
            pass

    with ThreadPoolExecutor(1) as pool:
        pool.submit(compute).result()
    assert limits() == {MANY}


def test_a_surface_of_the_user_is_evaluated_with_one_thread() -> None:
    seen = set()

    class Plane:
        def derivatives(self, parameters: np.ndarray) -> np.ndarray:
            seen.update(limits())
            result = np.zeros((*parameters.shape[:-1], 10, 3))
            result[..., 0, :2] = parameters
            result[..., 1, 0] = result[..., 2, 1] = 1.0
            return result

    assert bm.solve_geodesic(Plane(), (0, 0), (1, 1)).length == pytest.approx(np.sqrt(2.0))
    assert seen == {1}
    assert limits() == {MANY}


def test_every_public_function_that_computes_is_held_to_one_thread() -> None:
    public = {name for name in bm.__all__ if inspect.isfunction(getattr(bm, name))}
    assert public >= WITHOUT
    held = {
        node.name
        for module in all_modules()
        for node in module.tree.body
        if isinstance(node, ast.FunctionDef)
        and "one_blas_thread()" in map(ast.unparse, node.decorator_list)
    }
    assert public - WITHOUT <= held, f"decorate with @one_blas_thread(): {public - WITHOUT - held}"


@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="Linux counts what threads do")
@pytest.mark.parametrize(
    "work",
    [
        pytest.param(PATCHES % "2:3", id="patches"),
        pytest.param(PATCHES % ":", id="more patches", marks=pytest.mark.slow),
        pytest.param(BODY, id="body", marks=pytest.mark.slow),
    ],
)
def test_no_thread_is_woken(work: str) -> None:
    command = [sys.executable, "-c", SCRIPT % work]
    run = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    assert run.stdout.split() == ["asleep"]
