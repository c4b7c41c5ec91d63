"""Wavefront OBJ: quads with texture coordinates, grouped by the parts of the body."""

import numpy as np

from bodymeasure.fit.export.body_mesh import PARTS, BodyMesh, quad_parts, texture
from bodymeasure.fit.model import body_model


def obj_content(mesh: BodyMesh) -> bytes:
    """Return the content of a file. Its unit is the meter."""
    places, corners = texture()
    lines = [
        f"# {line}" for line in (mesh.name, mesh.described, "meters, y up, front = +z") if line
    ]
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"vt {u:.6f} {v:.6f}" for u, v in places.tolist()]
    lines.append("o body")
    both = np.stack([body_model().quads, corners], axis=2) + 1
    parts = quad_parts()
    for number, name in enumerate(PARTS):
        lines.append(f"g {name}")
        for quad in both[parts == number].tolist():
            lines.append("f " + " ".join(f"{vertex}/{place}" for vertex, place in quad))
    return ("\n".join(lines) + "\n").encode()
