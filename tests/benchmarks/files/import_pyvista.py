"""How long `import pyvista` takes with bodymeasure installed, and without.

Run it by hand: ``python tests/benchmarks/files/import_pyvista.py [--rounds 20]``.

Two folders hold the same packages, those of this environment; only one of them has bodymeasure,
with its entry points. Each round imports pyvista in fresh processes: with, without, and without
once more, in an order drawn anew. The script prints the processor times, the median over the rounds
of the ratio of with to without, and that of without to without, which shows the part of chance.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median, quantiles

import bodymeasure

NAME = "bodymeasure"
# Run without `site`, so that the folder given is all that is there besides the standard library.
SCRIPT = """
import sys, time
sys.path.append(sys.argv[1])
begin = time.process_time()
import pyvista
taken = time.process_time() - begin
from importlib.metadata import entry_points
found = {p.value for p in entry_points(group="pyvista.accessors")}
loaded = [name for name in sys.modules if name.partition(".")[0] == "bodymeasure"]
print(taken, any(value.startswith("bodymeasure") for value in found), len(loaded))
"""
KINDS = ("with", "without", "without again")


def fill(folder: Path, *, with_package: bool) -> Path:
    """A folder with links to all packages that can be imported here."""
    folder.mkdir()
    for parent in map(Path, sys.path):
        if parent.name not in ("site-packages", "dist-packages") or not parent.is_dir():
            continue
        for item in parent.iterdir():
            own = NAME in item.name
            link = folder / item.name
            if not link.exists() and item.suffix != ".pth" and (with_package or not own):
                link.symlink_to(item)
    if with_package and not (folder / NAME).exists():
        # An editable installation has no folder of its own.
        (folder / NAME).symlink_to(Path(bodymeasure.__file__).parent)
    return folder


def seconds(folder: Path, *, with_package: bool) -> float:
    """Processor time of `import pyvista` in a fresh process."""
    done = subprocess.run(
        [sys.executable, "-I", "-S", "-c", SCRIPT, str(folder)],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    taken, has_accessor, loaded = done.stdout.split()
    if (has_accessor == "True") != with_package:
        raise SystemExit(f"{folder}: expected entry points of {NAME}: {with_package}")
    if int(loaded):
        raise SystemExit(f"import pyvista loaded {loaded} modules of {NAME}; expected none")
    return float(taken)


def main() -> None:
    parser = argparse.ArgumentParser(
        description="Time import pyvista with and without the plug-in."
    )
    parser.add_argument("--rounds", type=int, default=20, metavar="N")
    rounds = parser.parse_args().rounds
    taken: dict[str, list[float]] = {kind: [] for kind in KINDS}
    with tempfile.TemporaryDirectory() as scratch:
        there = fill(Path(scratch, "with"), with_package=True)
        not_there = fill(Path(scratch, "without"), with_package=False)
        for number in range(-1, rounds):
            for kind in random.sample(KINDS, len(KINDS)):
                installed = kind == "with"
                took = seconds(there if installed else not_there, with_package=installed)
                # The first round fills the disk's cache.
                if number >= 0:
                    taken[kind].append(took)
    for kind, times in taken.items():
        print(f"{kind:13}  median {median(times):.3f} s, least {min(times):.3f} s")
    for top in ("with", "without again"):
        ratios = [a / b for a, b in zip(taken[top], taken["without"], strict=True)]
        low, _, high = quantiles(ratios, n=4)
        print(f"{top} / without: median {median(ratios):.3f}, quartiles {low:.3f} to {high:.3f}")


if __name__ == "__main__":
    main()
