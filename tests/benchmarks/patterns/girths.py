"""How wide the closed bodice is at the level of the bust, against the skin, with and without ease.

Edges of pieces are exact; inside of a piece, the cloth gives, and this says by how much.
"""

import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import evaluate

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
EASE = {"bust": 0.04, "waist": 0.02}


def level_line(triangles: Ints, above: Array, positions: Array) -> float:
    """The length of the line at which a height is zero, in some layout of the mesh."""
    total = 0.0
    for triangle in triangles:
        ends = []
        for one, other in zip(triangle, np.roll(triangle, -1), strict=True):
            if (above[one] > 0.0) != (above[other] > 0.0):
                part = above[one] / (above[one] - above[other])
                ends.append((1.0 - part) * positions[one] + part * positions[other])
        if ends:
            total += float(np.linalg.norm(ends[0] - ends[1]))
    return total


def bust(body: bm.Atlas, ease: dict[str, float] | None) -> tuple[float, float]:
    """The line at the bust's level round the whole body, in mm: on the skin, and in the pieces."""
    up = body.axes.up_vector
    height = body.position(body.landmarks["bust point left"]) @ up
    lengths = np.zeros(2)
    for piece in bm.make_pattern(body, "bodice", ease=ease).pieces:
        mesh = piece.flat.mesh
        skin = evaluate(body.control_points[mesh.places.patch], mesh.places.parameters)
        above = skin @ up - height
        lengths += [level_line(mesh.triangles, above, x) for x in (skin, piece.flat.positions)]
    # Both pieces are halves.
    on_skin, in_pieces = (2000.0 * body.unit.meters * lengths).tolist()
    return on_skin, in_pieces


if __name__ == "__main__":
    print(f"{'body':18}{'skin':>8}{'pieces':>8}{'wider':>8}{'with ease':>11}{'wider':>8}  (mm)")
    for name in BODIES:
        sample = bm.load_sample(name)
        skin, bare = bust(sample, None)
        _, eased = bust(sample, EASE)
        print(
            f"{name:18}{skin:8.1f}{bare:8.1f}{bare - skin:+8.1f}{eased:11.1f}{eased - skin:+8.1f}"
        )
