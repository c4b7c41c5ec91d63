"""Damage valid mesh files in thousands of ways, and see that each is read or refused at once.

Run it by hand: ``python tests/benchmarks/files/fuzz_scans.py [--mutations 10000] [--seed 0]
[--only NAME]``.

For each kind of file it prints how many mutations were refused and how many were read, the most
processor time that one took, and by how much the process grew. It ends with code 1 if one raised an
error other than `InputError`, took more than a second, gave a scan with numbers that are not finite
or with much of the mesh lost in silence, or made the process grow beyond bounds.
"""

import argparse
import os
import sys
from functools import partial
from pathlib import Path

os.environ["OMP_NUM_THREADS"] = "1"
sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.files.fuzzing import survives
from helpers.scans.damaged import mesh_files, scan_or_refused


def main() -> int:
    parser = argparse.ArgumentParser(description="Damage mesh files of all kinds, and read them.")
    parser.add_argument("--mutations", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", choices=list(mesh_files()))
    arguments = parser.parse_args()
    well = [
        survives(
            name,
            content,
            partial(scan_or_refused, extension=extension),
            arguments.mutations,
            arguments.seed,
        )
        for name, (extension, content) in mesh_files().items()
        if arguments.only in (None, name)
    ]
    return 0 if all(well) else 1


if __name__ == "__main__":
    sys.exit(main())
