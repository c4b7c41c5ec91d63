"""Make the sample atlases: ``python -m bodymeasure.sample_patches.build SOURCE OUTPUT``.

SOURCE holds the mannequins as they were fitted: ``atlas_376.npz`` (control points of all bodies on
one layout), ``mesh_<body>.obj`` (each body's Catmull-Clark control mesh) and ``landmarks.json``
(vertex numbers of landmarks on those meshes). Single patches of known geometry are made as well,
and the file of the quad meshes.
"""

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from bodymeasure.atlas import Atlas, Axes, Unit
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.extremities import extremity_lengths
from bodymeasure.formats import write_atlas

from .control_mesh import ControlMesh, limit_positions, read_landmarks, read_mesh
from .naming import name_patches
from .quad_meshes import write_quad_meshes
from .surfaces import known_surfaces

TITLES = {
    "female_average": "Average female body, 160.5 cm",
    "male_average": "Average male body, 174.8 cm",
    "female_heavy": "Heavy female body, 160.5 cm",
    "female_full_bust": "Female body with a full bust, 160.5 cm",
    "female_old": "Old female body, 159.4 cm",
}
# The body that decides the names, which all bodies share with the layout.
NAMED_AFTER = "female_average"
# The group of the mesh's quads that the atlas covers: neck to wrists and ankles.
COVERED = "dress_form"
PROVENANCE = {
    "source": "MakeHuman hm08 base mesh and morph targets, released by their authors as CC0 1.0",
    "license": "CC0 1.0 (public domain), https://creativecommons.org/publicdomain/zero/1.0/",
    "method": "morph targets applied to the base mesh; natal cleft, navel and nipples smoothed, as "
    "on a dress form; 376 bicubic Bezier patches, one layout for all bodies, fitted by least "
    "squares to the mesh's Catmull-Clark limit surface, from the neck to the wrists and ankles; "
    "watertight, seams nearly smooth",
    "pose": "A-pose, soles at z = 0",
}
# A landmark further than this from the atlas lies on what it does not cover, such as a foot: it
# cannot be given a place. The fit itself is off by 1.5 mm at worst.
LANDMARK_REACH = 0.003
# A landmark this close to a patch's edge, in (u, v), is put on it: landmarks of the center line lie
# some micrometers beside it where its seam is slightly creased.
SNAP = 2e-4


def main() -> None:
    """Read the command line and make all samples."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("source", type=Path, help="folder with the fitted mannequins")
    parser.add_argument("output", type=Path, help="folder for the samples")
    arguments = parser.parse_args()
    atlases = mannequins(arguments.source) | dict(known_surfaces())
    for name, atlas in atlases.items():
        write_atlas(atlas, arguments.output / f"{name}.atlas")
    meshes = {body: read_mesh(arguments.source / f"mesh_{body}.obj") for body in TITLES}
    write_quad_meshes(meshes, COVERED, arguments.output)


def mannequins(source: Path) -> dict[str, Atlas]:
    """The bodies of a source folder, by name, with names, regions, landmarks and provenance."""
    with np.load(source / "atlas_376.npz") as data:
        bodies = {
            body: _with_landmarks(
                Atlas(
                    points=data[f"points_{body}"],
                    index=data["index"],
                    unit=Unit.M,
                    axes=Axes(up="+z", front="-y"),
                    name=title,
                    provenance=PROVENANCE,
                ),
                source,
                body,
            )
            for body, title in TITLES.items()
        }
    patch_names, regions = name_patches(bodies[NAMED_AFTER])
    return {
        body: replace(atlas, patch_names=patch_names, regions=regions)
        for body, atlas in bodies.items()
    }


def _with_landmarks(atlas: Atlas, source: Path, body: str) -> Atlas:
    """The atlas with landmarks, head, hands and feet, and distances as provenance."""
    mesh = read_mesh(source / f"mesh_{body}.obj")
    numbers = read_landmarks(source / "landmarks.json")
    limits = limit_positions(mesh, list(numbers.values()))
    landmarks, residuals, outside = {}, [], []
    for name, limit, nearest in zip(numbers, limits, closest_points(atlas, limits)[0], strict=True):
        point = nearest._replace(u=_onto_edge(nearest.u), v=_onto_edge(nearest.v))
        distance = np.linalg.norm(atlas.position(point) - limit)
        if distance > LANDMARK_REACH:
            outside.append(name)
            continue
        landmarks[name] = point
        residuals.append(f"{name} {1e3 * distance:.3f} mm")
    added = {
        "landmark distances": "from the limit positions of control mesh vertices to the atlas: "
        + ", ".join(residuals),
        "fit": _fit(atlas, mesh),
    }
    if outside:
        added["landmarks left out"] = f"not on what the atlas covers: {', '.join(outside)}"
    return replace(
        atlas,
        landmarks=landmarks,
        provenance=dict(atlas.provenance) | added,
        given=extremity_lengths(mesh.vertices, mesh.quads),
    )


def _onto_edge(parameter: float) -> float:
    nearest = float(round(parameter))
    return nearest if abs(parameter - nearest) < SNAP else parameter


def _fit(atlas: Atlas, mesh: ControlMesh) -> str:
    """Return the distances of the body's surface from the atlas in words."""
    covered = np.unique(mesh.groups[COVERED])
    _, distances = closest_points(atlas, limit_positions(mesh, covered.tolist()))
    millimeters = 1e3 * distances
    return (
        f"limit positions of the {len(covered)} control mesh vertices that the atlas covers lie "
        f"off it by {np.sqrt(np.mean(millimeters**2)):.2f} mm RMS, "
        f"{np.quantile(millimeters, 0.99):.2f} mm at the 99th percentile, "
        f"{millimeters.max():.2f} mm at worst"
    )


if __name__ == "__main__":
    main()
