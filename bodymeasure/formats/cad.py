"""STEP and IGES files: B-spline surfaces, and the faces of solids, cut into Bezier patches.

Read by Open CASCADE (extra ``cad``) in a process of its own, which a broken file may end without
harm. Coordinates are in millimeters, whatever the file is in: Open CASCADE converts them.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import spline_patches

_Array = NDArray[np.float64]

# Seconds. A body of ten thousand faces takes a minute.
LONGEST = 600.0


def _read(content: bytes, source: str, *, kind: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    if find_spec("OCP") is None:
        raise MissingExtraError(f"reading {source}", "cadquery-ocp-novtk", "cad")
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder, f"file.{kind}"), Path(folder, "surfaces.npz")
        given.write_bytes(content)
        # By its path, since it needs nothing of the package, which takes a second to import.
        worker = str(Path(__file__).with_name("cad_worker.py"))
        try:
            done = subprocess.run(
                [sys.executable, "-P", worker, str(given), str(found)],
                capture_output=True,
                timeout=LONGEST,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise InputError(
                f"{source}: Open CASCADE did not read it in {LONGEST:.0f} s; export fewer faces"
            ) from None
        if done.returncode != 0 or not found.exists():
            raise InputError(
                f"{source}: is no {kind.upper()} file that Open CASCADE can read; expected one "
                "with surfaces; it may have been cut off or edited by hand"
            )
        with np.load(found) as arrays:
            return _patches(dict(arrays), source)


def _patches(arrays: Mapping[str, NDArray[Any]], source: str) -> ReadPatches:
    nets: list[_Array] = []
    weights: list[_Array] = []
    places: list[str] = []
    notes: list[str] = []
    faces = json.loads(str(arrays["faces"]))
    for number, face in enumerate(faces):
        place = f"face {number + 1}"
        if face["trimmed"]:
            notes.append(f"{place} is trimmed; its underlying surface is taken")
        try:
            own_nets, own_weights = spline_patches(
                arrays[f"points {number}"],
                arrays[f"weights {number}"],
                tuple(face["degrees"]),
                (arrays[f"knots u {number}"], arrays[f"knots v {number}"]),
            )
        except InputError as error:
            raise InputError(f"{source}, {place}: {error}") from None
        nets += own_nets
        weights += own_weights
        places += [place] * len(own_nets)
    return ReadPatches(nets, weights, places, [""] * len(nets), places, unit=Unit.MM, notes=notes)


read_step = partial(_read, kind="step")
read_iges = partial(_read, kind="iges")
