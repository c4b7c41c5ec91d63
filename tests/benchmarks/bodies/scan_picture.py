"""README's picture of a scan that goes in and a chart that comes out: viewer/scan.png.

python tests/benchmarks/bodies/scan_picture.py [SCAN UNIT] [--output FILE]

From left to right: the scan, the body that was fitted to it, colored by the distance between the
two, and the tapes of some measurements on it.
"""

import argparse
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure.atlas import Axes
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.report.fits.drawn import meshes
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.drawing.picture import Picture
from bodymeasure.scene.drawing.visibility import sight
from bodymeasure.scene.figures.canvas import png
from bodymeasure.scene.fits.pictures import LIFT, distance_colors, surface_of, vertex_normals
from bodymeasure.scene.tapes.build import tapes_scene
from bodymeasure.scene.tapes.gallery import body_picture, roomy_views

ROOT = Path(__file__).parents[3]
PIXELS = 620
KEYS = (
    "neck_base_girth", "bust_girth", "waist_girth", "hip_girth", "thigh_girth", "knee_girth",
    "upper_arm_girth", "front_neck_to_waist", "side_neck_to_bust",
)  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scan", nargs="?", default=ROOT / "tests/data/scans/coarse.ply")
    parser.add_argument("unit", nargs="?", default="m")
    parser.add_argument("--output", type=Path, default=ROOT / "viewer/scan.png")
    options = parser.parse_args()
    fitted = bm.fit_body(options.scan, file_unit=options.unit)
    chart = bm.measure_chart(fitted.atlas, only=KEYS)
    scene = tapes_scene(chart)
    view = roomy_views(scene, fitted.atlas.axes)["front"]
    body, scan = meshes(fitted)
    # The whole body is seen, of which the atlas has no head, hands and feet.
    low, high = body.points[:, 2].min(), body.points[:, 2].max()
    width = 1.06 * float(np.ptp(body.points[:, 0]))
    middle = 0.5 * (body.points[:, 0].min() + body.points[:, 0].max())
    center = np.array([middle, view.center[1], 0.5 * (low + high)])
    view = type(view)(center, view.towards, view.up, width, 1.03 * float(high - low))
    colored = Mesh(
        body.points + LIFT * Axes().front_vector,
        vertex_normals(body),
        body.triangles,
        distance_colors(fitted.distance),
        np.zeros(len(body.triangles), dtype=np.int64),
    )
    with RENDERERS[choose_renderer(None).renderer]() as draw:
        size = view.size(PIXELS)
        tapes = body_picture(scene, scene.tapes, [], sight(scene.surface, view))
        images = [
            draw(Picture(surface_of(scan), view, size)),
            draw(Picture(surface_of(scan), view, size, colored)),
            draw(Picture(surface_of(body), view, size, tapes.tubes)),
        ]
    options.output.write_bytes(png(np.concatenate(images, axis=1)))
    print(options.output)
    for item in chart.measured:
        uncertain = item.input_uncertainty or 0.0
        print(f"{item.definition.name:45s} {100 * item.value:6.1f} cm +- {1e3 * uncertain:.1f} mm")


if __name__ == "__main__":
    main()
