"""How long `import bodymeasure` takes, and its parts when they are first asked for.

Run it by hand: ``python tests/benchmarks/files/import_time.py [--rounds 10]``.

Each round runs every script in a process of its own. The first script imports what the solver takes
from numpy and scipy, which no use of the package can do without; the last column is the time beyond
that. Times are processor times, medians over the rounds.
"""

import argparse
import os
import subprocess
import sys
from statistics import median

SCRIPTS = {
    "numpy and scipy alone": "import numpy, scipy.interpolate, scipy.linalg, scipy.special",
    "import bodymeasure": "import bodymeasure as bm",
    "... and load_sample": "import bodymeasure as bm; bm.load_sample",
    "... and solve_geodesic": "import bodymeasure as bm; bm.solve_geodesic",
    "... and measure_chart": "import bodymeasure as bm; bm.measure_chart",
    "every public name": "from bodymeasure import *",
}


def seconds(script: str) -> float:
    """Return the processor time of a script in a new process, without that of its start."""
    timed = (
        f"import time; begin = time.process_time(); {script}; print(time.process_time() - begin)"
    )
    done = subprocess.run(
        [sys.executable, "-c", timed],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    return float(done.stdout)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=10, metavar="N")
    rounds = parser.parse_args().rounds
    # The first round fills the disk's cache.
    taken = [[seconds(script) for script in SCRIPTS.values()] for _ in range(rounds + 1)][1:]
    medians = [median(times) for times in zip(*taken, strict=True)]
    for name, time in zip(SCRIPTS, medians, strict=True):
        print(f"{name:24} {time:6.3f} s  {time - medians[0]:+6.3f} s")


if __name__ == "__main__":
    main()
