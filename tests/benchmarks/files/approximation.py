"""How far lengths on the patches of a mesh are from those on its Catmull-Clark surface.

Run it by hand: ``python tests/benchmarks/files/approximation.py --pairs 300``.

The surface is found by repeated subdivision with exact limits, and distances on it by libigl on two
such meshes, extrapolated. The patches are measured between the points closest to the same vertices.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
from pathlib import Path
from typing import NamedTuple

import igl
import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.registry import FORMATS, decode
from bodymeasure.subdivision import PolygonMesh, loop_schaefer, refined

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.surfaces.solids import CUBE, blob, icosphere, obj_text

# Quads of the finest mesh at most, and steps of subdivision between the meshes.
QUADS = 25_000
TARGETS = 50
# Extrapolated distances agree better by chance than they are: with lengths on patches three steps
# finer they differ by up to five times their change, and by up to 1e-6.
SAFETY, FLOOR = 5.0, 2e-6


class Truth(NamedTuple):
    """Distances on the surface from one vertex, shape (k,), and how uncertain they are."""

    positions: Array
    distances: Array
    uncertain: Array


def limit_mesh(mesh: PolygonMesh) -> tuple[Array, Ints]:
    """Limits of the vertices, and triangles."""
    points = loop_schaefer(mesh).points[: len(mesh.vertices)]
    return points, mesh.corners.reshape(-1, 4)[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)


def levels(mesh: PolygonMesh) -> list[tuple[Array, Ints]]:
    """Three meshes, each with the vertices of the one before it and more."""
    found = []
    while len(mesh.corners) <= QUADS:
        mesh = refined(mesh)
        found.append(limit_mesh(mesh))
    return found[-3:]


def truth(meshes: list[tuple[Array, Ints]], source: int, targets: Ints) -> Truth:
    none = np.empty(0, dtype=np.int64)
    found = [
        np.asarray(igl.exact_geodesic(points, faces, np.array([source]), none, targets, none))
        for points, faces in meshes
    ]
    best = found[2] + (found[2] - found[1]) / 3.0
    before = found[1] + (found[1] - found[0]) / 3.0
    positions = meshes[0][0][np.append(source, targets)]
    uncertain = SAFETY * np.abs(best - before) + FLOOR * best
    return Truth(positions, best, uncertain)


def report(name: str, mesh: PolygonMesh, pairs: int, deviation: float | None) -> tuple[int, int]:
    text = obj_text(mesh).encode()
    options = ReadOptions(unit=bm.Unit.CM, deviation=deviation)
    atlas = decode(text, name, FORMATS["obj"], options)
    meshes, rng = levels(mesh), np.random.default_rng(1)
    errors, stated, outside = [], [], 0
    for _ in range(0, pairs, TARGETS):
        source, *targets = rng.choice(len(meshes[0][0]), TARGETS + 1, replace=False)
        true = truth(meshes, int(source), np.array(targets))
        points, _ = closest_points(atlas, true.positions)
        paths = bm.geodesics_between(atlas, [points[0]] * TARGETS, points[1:], on_failure="status")
        for path, length, uncertain in zip(paths, true.distances, true.uncertain, strict=True):
            if not path.converged:
                continue
            error = abs(path.length - length)
            bound = path.approximation_error
            errors.append(error / length)
            stated.append(bound / length)
            outside += bool(error > bound + path.error_estimate + uncertain)
    print(
        f"{name:12} {len(atlas):5} patches, {len(errors)} pairs: relative error median "
        f"{np.median(errors):.1e}, largest {np.max(errors):.1e}; stated median "
        f"{np.median(stated):.1e}, largest {np.max(stated):.1e}; outside {outside}",
        flush=True,
    )
    return outside, len(errors)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=100, help="for each solid")
    parser.add_argument("--blobs", type=int, default=3)
    arguments = parser.parse_args()
    solids = {"cube": CUBE, **{f"blob {k}": blob(k) for k in range(arguments.blobs)}}
    solids["sphere 320"] = icosphere(2)
    counts = np.zeros(2, dtype=np.int64)
    for deviation in (np.inf, None):
        for name, mesh in solids.items():
            counts += report(name, mesh, arguments.pairs, deviation)
    print(f"{counts[0]} of {counts[1]} lengths outside what they state")


if __name__ == "__main__":
    main()
