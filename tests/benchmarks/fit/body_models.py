"""Bodies of models with a fixed topology: how close the atlas is, how long it takes, and measures.

python tests/benchmarks/fit/body_models.py [--fit] [BODY.npz ...]

Without files, ten posed bodies of the space are mapped: by hm08's topology, against the limit
surface of their mesh, and by a stored correspondence of another topology (the dual mesh), against
its facets. A file has `vertices` in meters and `faces` of a model, and perhaps clad-body's
`measures`, as anny_bodies.py writes it: it is mapped both ways, and fitted as a scan with --fit.
Girths are taut and horizontal, at the height at which clad-body measures, as those of
SMPL-Anthropometry are: convex hulls of plane sections. Times are processor time.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))

import igl
from helpers.bodies_in_poses import body_in_pose
from helpers.foreign_body import foreign_triangles, foreign_vertices

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import atlas_of_vertices, body_model
from bodymeasure.fit.topology import (
    Polygons,
    Topology,
    known_topology,
    mapped_body,
    mapped_vertices,
    polygons_of,
    posture_of,
    recognized,
    require,
    topology_of_fit,
)
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide

# clad-body's name, its name of the height, and a landmark of ours that is near the girth.
GIRTHS = (
    ("bust_cm", "_bust_z", "bust point left"),
    ("waist_cm", "_waist_z", "front waist point"),
    ("hip_cm", "_hip_z", "side hip point left"),
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fit", action="store_true")
    parser.add_argument("files", nargs="*", type=Path)
    given = parser.parse_args()
    if given.files:
        for file in given.files:
            of_file(file, given.fit)
    else:
        of_the_space()


def of_the_space() -> None:
    mean = body_model().mean
    triangles = foreign_triangles()
    rest = polygons_of(foreign_vertices(mean), triangles)
    dual = topology_of_fit(rest, rest.vertices, mean, "dual")
    for number in range(10):
        vertices = body_in_pose(number)[0]
        hm08 = polygons_of(vertices, body_model().quads)
        found = recognized(hm08)
        assert found is not None
        report(f"body {number} hm08", hm08, found, limit_mesh(vertices))
        mesh = polygons_of(foreign_vertices(vertices), triangles)
        report(f"body {number} dual", mesh, dual, (mesh.vertices, triangles))


def limit_mesh(vertices: Array) -> tuple[Array, Ints]:
    """Triangles of the limit surface after two steps, some 0.02 mm within it."""
    mesh = subdivide(subdivide(QuadMesh(vertices, body_model().quads)))
    quads = mesh.quads
    return limit_positions(mesh), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def report(label: str, mesh: Polygons, topology: Topology, truth: tuple[Array, Ints]) -> bm.Atlas:
    start = time.process_time()
    require(mesh, topology, label)
    checked = time.process_time()
    body = mapped_body(mesh, topology, bm.Unit.M)
    atlas = atlas_of_vertices(body.vertices)
    mapped = time.process_time()
    posture = posture_of(mapped_vertices(mesh.vertices, topology))
    ended = time.process_time()
    surface = truth[0] @ body.transform[:3, :3].T + body.transform[:3, 3]
    away = distances(atlas, surface, truth[1])
    print(
        f"{label:40} RMS {away[0]:.2f} mm, 95 % {away[1]:.2f}, worst {away[2]:.1f}; recognized in "
        f"{1e3 * (checked - start):.0f} ms, mapped in {1e3 * (mapped - checked):.0f}, pose in "
        f"{1e3 * (ended - mapped):.0f}; {1e3 * posture.residual:.1f} mm off the space",
        flush=True,
    )
    return atlas


def distances(atlas: bm.Atlas, vertices: Array, triangles: Ints) -> tuple[float, float, float]:
    """RMS, 95 % and largest distance of an atlas from a mesh, in millimeters."""
    points = bm.tessellate(atlas, 5).vertices
    away = 1e3 * np.sqrt(igl.point_mesh_squared_distance(points, vertices, triangles)[0])
    return float(np.sqrt((away**2).mean())), float(np.quantile(away, 0.95)), float(away.max())


def of_file(file: Path, fits: bool) -> None:
    with np.load(file) as data:
        vertices, faces = data["vertices"].astype(float), data["faces"].astype(np.int64)
        measures = json.loads(str(data["measures"])) if "measures" in data else {}
    mesh = polygons_of(vertices, faces)
    for name in ("hm08", "hm08 faces") if recognized(mesh) else ():
        atlas = report(
            f"{file.stem} {name}", mesh, known_topology(name, mesh, name), (vertices, faces)
        )
        shift = mapped_body(mesh, known_topology(name, mesh, name), bm.Unit.M).transform[2, 3]
        side_by_side(atlas, measures, shift)
    if fits:
        start = time.process_time()
        body = bm.fit_body((vertices, faces), file_unit="m", topology=None)
        took = time.process_time() - start
        surface = vertices @ body.transform[:3, :3].T + body.transform[:3, 3]
        away = distances(body.atlas, surface, faces)
        arms = [body.atlas.position(f"bust point {side}")[0] for side in ("left", "right")]
        print(
            f"{file.stem + ' fitted':40} RMS {away[0]:.2f} mm, 95 % {away[1]:.2f}, worst "
            f"{away[2]:.1f}; {took:.0f} s; left is left: {arms[0] > 0.0 > arms[1]}",
            flush=True,
        )
        side_by_side(body.atlas, measures, body.transform[2, 3])


def side_by_side(atlas: bm.Atlas, measures: dict[str, float], shift: float) -> None:
    for key, height, landmark in GIRTHS if measures else ():
        level = np.array([0.0, 0.0, measures[height] + shift])
        plane = bm.Plane(level, np.array([0.0, 0.0, 1.0]))
        girth = bm.plane_girth(atlas, plane, landmark)
        theirs = 10.0 * measures[key]
        print(
            f"    {key.removesuffix('_cm'):6} clad-body {theirs:7.1f} mm, ours "
            f"{1e3 * girth.taut:7.1f}, difference {1e3 * girth.taut - theirs:+.1f}"
        )


if __name__ == "__main__":
    main()
