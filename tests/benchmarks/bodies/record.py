"""Write a record of the package's lengths to a folder, and compare two records.

This is for a change that must not alter any number, or only in the last digits::

    python tests/benchmarks/bodies/record.py write before
    python tests/benchmarks/bodies/record.py write after      # once the change is made
    python tests/benchmarks/bodies/record.py compare before after

The record holds the diagonals and the charts of the five bodies and the quick tables of the paper,
as the command line writes them, without dates, times and versions.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
# Members that differ from run to run, or from release to release.
PASSING = {"created", "seconds", "versions", "processes"}
# Words in the names of numbers that are of the size of rounding errors, so that their relative
# differences say nothing.
SMALL = ("error", "residual", "gap", "difference")


def _run(*arguments: str) -> str:
    """Return what the command prints. Exit code 1 means that a result needs to be looked at."""
    command = [sys.executable, "-m", "bodymeasure", *arguments]
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    run = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if run.returncode not in {0, 1}:
        raise SystemExit(f"{' '.join(arguments)}: {run.stderr}")
    return run.stdout


def _lasting(value: Any) -> Any:
    """Return a document without what differs from run to run, such as columns of times."""
    if isinstance(value, dict):
        kept = {name: _lasting(item) for name, item in value.items() if name not in PASSING}
        if {"columns", "rows"} <= kept.keys():
            timings = {column["name"] for column in kept["columns"] if column["timing"]}
            kept["rows"] = [
                {name: cell for name, cell in row.items() if name not in timings}
                for row in kept["rows"]
            ]
        return kept
    return [_lasting(item) for item in value] if isinstance(value, list) else value


def _write(folder: Path, bodies: list[str]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    documents = {}
    for body in bodies:
        for command in ("diagonals", "chart"):
            documents[f"{command}_{body}"] = json.loads(_run(command, body, "--format", "json"))
    with tempfile.TemporaryDirectory() as scratch:
        _run("paper", "--quick", "--seed", "2007", "-o", scratch)
        tables = json.loads((Path(scratch) / "tables.json").read_text("utf-8"))
    # Tables of speed are left out: they have the word in their names, and the accuracies of the
    # same runs are in the other tables.
    tables["tables"] = {
        name: table for name, table in tables["tables"].items() if "speed" not in name
    }
    documents["paper"] = tables
    for name, document in documents.items():
        text = json.dumps(_lasting(document), indent=1, sort_keys=True)
        (folder / f"{name}.json").write_text(text, "utf-8")


def _differences(before: Any, after: Any, place: str) -> Iterator[tuple[str, Any, Any]]:
    """Yield the places at which two documents differ, with both values."""
    if isinstance(before, dict) and isinstance(after, dict):
        for name in sorted(before.keys() | after.keys()):
            yield from _differences(before.get(name), after.get(name), f"{place}/{name}")
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for number, pair in enumerate(zip(before, after, strict=True)):
            name = pair[0].get("key", pair[0].get("name")) if isinstance(pair[0], dict) else None
            yield from _differences(*pair, f"{place}/{name or number}")
    elif before != after:
        yield place, before, after


def _compare(before: Path, after: Path, shown: int) -> int:
    """Print how far two records are apart, and return 1 if anything but numbers differs."""
    names = sorted({path.name for folder in (before, after) for path in folder.glob("*.json")})
    worst, words = 0.0, 0
    for name in names:
        texts = [(folder / name).read_text("utf-8") for folder in (before, after)]
        if texts[0] == texts[1]:
            print(f"{name}: identical")
            continue
        relative, others = [], []
        for place, old, new in _differences(json.loads(texts[0]), json.loads(texts[1]), ""):
            numbers = all(isinstance(value, float) and math.isfinite(value) for value in (old, new))
            if numbers and any(word in place for word in SMALL):
                others.append((place, old, new))
            elif numbers:
                relative.append((abs(new - old) / max(abs(old), abs(new)), place, old, new))
            else:
                words += 1
                print(f"{name}: {place}: {old!r} -> {new!r}")
        relative.sort(reverse=True)
        worst = max([worst] + [item[0] for item in relative])
        print(f"{name}: {len(relative)} numbers and {len(others)} estimates or gaps differ")
        for size, place, old, new in relative[:shown]:
            print(f"    {size:.1e} {place}: {old!r} -> {new!r}")
    print(f"largest relative difference {worst:.1e}; {words} differences that are no numbers")
    return int(words > 0)


def main() -> int:
    """Write a record, or compare two."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    writing = commands.add_parser("write")
    writing.add_argument("folder", type=Path)
    writing.add_argument("--bodies", nargs="*", choices=BODIES, default=BODIES)
    comparing = commands.add_parser("compare")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    comparing.add_argument("--shown", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.command == "write":
        _write(arguments.folder, list(arguments.bodies))
        return 0
    return _compare(arguments.before, arguments.after, arguments.shown)


if __name__ == "__main__":
    sys.exit(main())
