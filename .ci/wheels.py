#!/usr/bin/env python3
"""Fail unless the package and each of its extras install from wheels alone, on every CPython.

Run it by hand: ``python .ci/wheels.py [VERSION ...]``, in an environment with pip. It resolves for
Linux on x86-64 and downloads nothing but metadata where the index has it apart. Whoever installs a
release has no compiler for what lacks a wheel.
"""

import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path

VERSIONS = ("3.11", "3.12", "3.13", "3.14")
# Old wheels have the names that these platforms had before.
PLATFORMS = ["manylinux1_x86_64", "manylinux2010_x86_64", "manylinux2014_x86_64"]
PLATFORMS += [f"manylinux_2_{minor}_x86_64" for minor in range(5, 36)]
FILE = Path(__file__).parents[1] / "pyproject.toml"
PROJECT = tomllib.loads(FILE.read_text("utf-8"))["project"]
OWN = re.compile(rf"{PROJECT['name']}\[([^\]]*)\]")


def requirements(extra: str) -> Iterator[str]:
    """Yield what an extra needs, through other extras too, or the package itself for ""."""
    own = PROJECT["optional-dependencies"][extra] if extra else PROJECT["dependencies"]
    for requirement in own:
        if match := OWN.match(requirement):
            for other in match[1].split(","):
                yield from requirements(other.strip())
        else:
            yield requirement


def found(version: str, needed: list[str]) -> str:
    """Return what pip says where it finds no wheels of all that is needed, or ""."""
    # pip evaluates markers for the Python that runs it.
    names = [each.partition(";")[0] for each in needed if marked(each, version)]
    tags = ["--implementation", "cp", "--python-version", version]
    for abi in (f"cp{version.replace('.', '')}", "abi3", "none"):
        tags += ["--abi", abi]
    for platform in PLATFORMS:
        tags += ["--platform", platform]
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "pip", "install", "--dry-run", "--quiet"]
        command += ["--target", folder, "--only-binary", ":all:", *tags, *names]
        run = subprocess.run(command, capture_output=True, text=True)
    errors = [line for line in run.stderr.splitlines() if line.startswith("ERROR")]
    return "" if run.returncode == 0 else "\n    ".join(errors or [run.stderr])


def marked(requirement: str, version: str) -> bool:
    """Return whether a requirement holds for a version; its marker may only name that."""
    marker = requirement.partition(";")[2].strip()
    if not marker:
        return True
    match = re.fullmatch(r"python_version (<|>=) '3\.(\d+)'", marker)
    if match is None:
        raise SystemExit(f"{requirement}: expected a marker such as python_version < '3.14'")
    return (int(version.partition(".")[2]) < int(match[2])) == (match[1] == "<")


def main() -> None:
    """Check the versions that are named, or all."""
    extras = ("", *PROJECT["optional-dependencies"])
    faults = []
    for version in sys.argv[1:] or VERSIONS:
        everything = sorted({each for extra in extras for each in requirements(extra)})
        if not found(version, everything):
            print(f"CPython {version}: wheels of all {len(everything)} requirements", flush=True)
            continue
        # Which of the extras it is takes one more run for each.
        for extra in extras:
            if words := found(version, sorted(set(requirements(extra)))):
                called = f"{PROJECT['name']}[{extra}]" if extra else PROJECT["name"]
                faults.append(f"CPython {version}: {called} has no wheels:\n    {words}")
    if faults:
        raise SystemExit("\n".join(faults))


if __name__ == "__main__":
    main()
