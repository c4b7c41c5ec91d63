"""Read a file by another library, in a process of its own, which a broken file may crash."""

import json
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import (
    faces_of_surfaces,
    notes_of_refused,
    spline_patches,
)

# Bytes that a reader gets through in some seconds. A broken file may keep it busy forever.
CHUNK = 2_000_000
# Reasons that an error quotes why a file has no surface; it counts the others.
_QUOTED = 3


class Reader(NamedTuple):
    """A script that reads one kind of file by another library.

    Parameters
    ----------
    script : str
        Beside this file; called with the file and what it has to write: an ``.npz`` file with the
        arrays ``points k``, ``weights k``, ``knots u k`` and ``knots v k`` of each surface, and as
        ``document`` JSON with the ``unit``, ``notes``, and of each of the ``faces`` its ``name``,
        ``group``, ``place`` and ``degrees``.
    kind, title : str
        Extension of the files, and what they are called.
    library : str
        The name of the library in errors.
    longest : float
        The seconds that it may take, and as many more for each `CHUNK` bytes.
    """

    script: str
    kind: str
    title: str
    library: str
    longest: float


def surfaces_of_file(content: bytes, source: str, reader: Reader) -> tuple[str, ReadPatches]:
    """Return the unit that a file states, and its surfaces cut into patches.

    Raises
    ------
    InputError
        If the library cannot read it, or no surface is a B-spline with positive weights and degrees
        that can be read. A note names those that are not.
    """
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder, f"file.{reader.kind}"), Path(folder, "surfaces.npz")
        given.write_bytes(content)
        # Run by its path: it needs nothing of the package, which takes a second to import.
        longest = reader.longest * (1 + len(content) // CHUNK)
        worker = str(Path(__file__).with_name(reader.script))
        try:
            done = subprocess.run(
                [sys.executable, "-P", worker, str(given), str(found)],
                capture_output=True,
                timeout=longest,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise InputError(
                f"{source}: {reader.library} did not read it in {longest:.0f} s; it may be "
                "damaged, or have very many faces: export fewer"
            ) from None
        if done.returncode != 0 or not found.exists():
            raise InputError(
                f"{source}: is no {reader.title} file that {reader.library} can read; "
                "expected one with surfaces; it may have been cut off or edited by hand"
            )
        with np.load(found) as arrays:
            return _patches(dict(arrays), source)


def _patches(arrays: Mapping[str, NDArray[Any]], source: str) -> tuple[str, ReadPatches]:
    document = json.loads(str(arrays["document"]))
    nets: list[Array] = []
    weights: list[Array] = []
    names: list[str] = []
    groups: list[str] = []
    places: list[str] = []
    notes: list[str] = document["notes"]
    refused: list[str] = []
    corners: list[Array] = []
    without: dict[str, str] = document["without"]
    times = Counter(face["place"] for face in document["faces"])
    for number, face in enumerate(document["faces"]):
        try:
            own_weights = arrays[f"weights {number}"]
            # `not positive` rather than `negative`, so that NaN is refused too.
            if not (own_weights > 0.0).all():
                raise InputError(
                    "has weights that are not positive, with which a surface has poles"
                )
            own = spline_patches(
                arrays[f"points {number}"],
                own_weights,
                tuple(face["degrees"]),
                (arrays[f"knots u {number}"], arrays[f"knots v {number}"]),
            )
        except InputError as error:
            refused.append(f"{face['place']}: {error}")
            without[face["place"]] = f"it is left out, since it {error}"
            continue
        corners.append(own.corners)
        if face["mirrored"]:
            # The worker has turned the control points and the knots in u around.
            knots = arrays[f"knots u {number}"]
            s, t = own.corners[..., 0], own.corners[..., 1]
            corners[-1] = np.stack([knots[-1] + knots[0] - s, t], axis=-1)
        if times[face["place"]] > 1:
            without[face["place"]] = "it is in the file several times, as a part of blocks"
        elif not face["own"]:
            without[face["place"]] = (
                "its surface was converted to a B-spline, whose parameters are others"
            )
        nets += own.nets
        weights += own.weights
        names += [face["name"]] * len(own.nets)
        groups += [face["group"]] * len(own.nets)
        places += [face["place"]] * len(own.nets)
    if notes and not nets and not refused:
        more = f" and {len(notes) - _QUOTED} more" if len(notes) > _QUOTED else ""
        raise InputError(
            f"{source}: holds no patch; expected at least one: {'; '.join(notes[:_QUOTED])}{more}"
        )
    notes += notes_of_refused(refused, source, any_read=bool(nets))
    faces = faces_of_surfaces(places, corners, without)
    found = ReadPatches(nets, weights, names, groups, places, notes=notes, faces=faces)
    return document["unit"], found
