"""How long it takes to read and write atlases of 10,000 patches, and to make one of 13,378 quads.

Run it by hand: ``python tests/benchmarks/files/formats.py [--side 100]``.

For each format it prints the size of the file and the processor time to write and to read it, for
OBJ also where patches share no vertices. For the mesh it prints the time to make the patches alone
and to read it from an OBJ file. Times are those of one thread, the shortest of three runs.
"""

import argparse
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.files.format_atlases import UNIT, read, write
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.quad_grids import grid_mesh

from bodymeasure import Atlas
from bodymeasure._typing import Array
from bodymeasure.formats import FORMATS
from bodymeasure.subdivision import PolygonMesh, loop_schaefer

RUNS = 3
# The mesh has as many quads as that of the whole body from which the samples are made.
ROWS, COLUMNS = 2, 6689


def seconds(call: Callable[[], object]) -> float:
    taken = []
    for _ in range(RUNS):
        begin = time.process_time()
        call()
        taken.append(time.process_time() - begin)
    return min(taken)


def bumpy(x: Array, y: Array) -> Array:
    heights = np.random.default_rng(0).normal(scale=0.01, size=x.shape)
    return np.stack([x, y, heights], axis=-1)


def time_format(label: str, name: str, atlas: Atlas) -> None:
    content = write(atlas, name)
    writing = seconds(lambda: write(atlas, name))
    reading = seconds(lambda: read(content, name))
    size = len(content) / 2**20
    print(f"{label:10} {size:5.1f} MiB  write {writing:.2f} s  read {reading:.2f} s")


def main() -> None:
    parser = argparse.ArgumentParser(description="Time the formats.")
    parser.add_argument("--side", type=int, default=100, help="patches along each side of a square")
    side = parser.parse_args().side
    atlas = grid_atlas(side, side, bumpy)
    print(f"{len(atlas):,} patches")
    for name, form in FORMATS.items():
        if form.write is not None:
            time_format(name, name, atlas)
    time_format("obj, loose", "obj", Atlas.from_control_points(atlas.control_points, UNIT))

    x, y = np.meshgrid(np.arange(ROWS + 1.0), np.arange(COLUMNS + 1.0), indexing="ij")
    mesh = grid_mesh(bumpy(x, y))
    corners, sizes = mesh.quads.ravel(), np.full(len(mesh.quads), 4)
    none = np.empty((0, 2), dtype=np.int64)
    made = seconds(lambda: loop_schaefer(PolygonMesh(mesh.vertices, corners, sizes, none)))
    lines = ["v " + " ".join(map(repr, point)) for point in mesh.vertices.tolist()]
    lines += ["f " + " ".join(str(k + 1) for k in quad) for quad in mesh.quads.tolist()]
    content = "\n".join(lines).encode()
    reading = seconds(lambda: read(content, "obj"))
    print(f"{len(mesh.quads):,} quads: patches {made:.2f} s, read from an OBJ file {reading:.2f} s")


if __name__ == "__main__":
    main()
