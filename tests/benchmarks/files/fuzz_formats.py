"""Damage valid files in thousands of ways, and see that each is read or refused at once.

Run it by hand: ``python tests/benchmarks/files/fuzz_formats.py [--mutations 10000] [--seed 0]
[--only NAME]``.

For each kind of file it prints how many mutations were refused and how many were read, the most
processor time that one took, and by how much the process grew. It ends with code 1 if one raised an
error other than `InputError`, took more than a second, left a number in the atlas that is not
finite, or made the process grow beyond bounds.
"""

import argparse
import os
import sys
import warnings
from functools import partial
from pathlib import Path

os.environ["OMP_NUM_THREADS"] = "1"
sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.files.fuzzing import survives
from helpers.files.mutations import read_or_refused, valid_files


def main() -> int:
    parser = argparse.ArgumentParser(description="Damage files of all formats, and read them.")
    parser.add_argument("--mutations", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", choices=list(valid_files()))
    arguments = parser.parse_args()
    warnings.simplefilter("error")
    well = [
        survives(
            name, content, partial(read_or_refused, form=form), arguments.mutations, arguments.seed
        )
        for name, (form, content) in valid_files().items()
        if arguments.only in (None, name)
    ]
    return 0 if all(well) else 1


if __name__ == "__main__":
    sys.exit(main())
