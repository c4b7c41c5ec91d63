"""What a survey costs: processor time, memory and bytes a body, and what processes add to it.

``python tests/benchmarks/bodies/survey_scaling.py 250 500 --only waist_girth,knee_height`` surveys
so many bodies of the space of bodies in one process, and the largest number in two. Each survey is
a process of its own, whose processor time is that of all that it starts. ``--diagonals 10000``
measures the diagonals of so many bodies in one call.
"""

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

COMPONENTS, SPREAD = 40, 0.6


def write_population(path: Path, count: int) -> None:
    """Write coefficients of random bodies."""
    rows = SPREAD * np.random.default_rng(17).normal(size=(count, COMPONENTS))
    np.savez(path, coefficients=rows.astype(np.float32))


def surveyed(path: Path, folder: Path, only: str, processes: int) -> None:
    """Survey a file here, and print what it cost."""
    import bodymeasure as bm

    keys = [key for key in only.split(",") if key]
    begin = time.perf_counter()
    table = bm.survey(path, folder=folder, only=keys, processes=processes)
    mine = resource.getrusage(resource.RUSAGE_SELF)
    theirs = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(
        json.dumps(
            {
                "bodies": len(table),
                "failed": len(table.failures),
                "processes": processes,
                "seconds": time.perf_counter() - begin,
                "parent": mine.ru_utime + mine.ru_stime,
                "workers": theirs.ru_utime + theirs.ru_stime,
                "parent_mib": mine.ru_maxrss / 1024.0,
                "worker_mib": theirs.ru_maxrss / 1024.0,
                "bytes": table.path.stat().st_size / len(table),
            }
        )
    )


def all_diagonals(count: int) -> None:
    """Measure the diagonals of so many bodies in one call, and print what it cost."""
    import bodymeasure as bm
    from bodymeasure.fit.model import atlas_of_vertices, control_points_of, shaped

    rows = SPREAD * np.random.default_rng(17).normal(size=(count, COMPONENTS))
    index = atlas_of_vertices(shaped(rows[0])).index
    nets = np.empty((count, *index.shape, 3))
    for net, row in zip(nets, rows, strict=True):
        net[...] = control_points_of(shaped(row))[index]
    begin = time.process_time()
    found = bm.diagonals_of_bodies(nets)
    spent = time.process_time() - begin
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    print(f"{found}: {spent:.1f} s of processors, memory {memory:.0f} MiB")


def main() -> None:
    """Survey populations of several sizes."""
    parser = argparse.ArgumentParser()
    parser.add_argument("counts", type=int, nargs="*")
    parser.add_argument("--diagonals", type=int, default=0, help="of so many bodies, alone")
    parser.add_argument("--only", default="")
    parser.add_argument("--here", nargs=3)
    given = parser.parse_args()
    if given.diagonals:
        all_diagonals(given.diagonals)
        return
    if given.here:
        path, folder, processes = given.here
        surveyed(Path(path), Path(folder), given.only, int(processes))
        return
    runs = [(count, 1) for count in given.counts] + [(max(given.counts), 2)]
    with tempfile.TemporaryDirectory() as folder:
        for count, processes in runs:
            path = Path(folder, f"{count}.npz")
            write_population(path, count)
            place = Path(folder, f"{count} {processes}")
            command = [sys.executable, __file__, "1", "--only", given.only]
            command += ["--here", str(path), str(place), str(processes)]
            found = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
            total = found["parent"] + found["workers"]
            print(
                f"{count:6} bodies, {processes} process{'es' if processes > 1 else ''}: "
                f"{total:7.1f} s of processors, {1000.0 * total / count:6.1f} ms a body; "
                f"{found['seconds']:6.1f} s on the clock; memory {found['parent_mib']:.0f} MiB"
                + (f" and {found['worker_mib']:.0f} a worker" if processes > 1 else "")
                + f"; {found['bytes']:.0f} bytes a body; {found['failed']} failed",
                flush=True,
            )


if __name__ == "__main__":
    main()
