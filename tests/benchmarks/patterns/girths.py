"""How wide the closed bodice is at the level of the bust, against the skin, with and without ease.

Edges of pieces are exact; inside of a piece, the cloth gives, and this says by how much.
"""

import bodymeasure as bm
from bodymeasure.bezier import evaluate
from bodymeasure.pattern.flat.level_line import level_line
from bodymeasure.section import Plane, plane_section

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
EASE = {"bust": 0.04, "waist": 0.02}


def in_pieces(body: bm.Atlas, ease: dict[str, float] | None) -> float:
    """The line at the bust's level round the whole body, as it is in the pieces, in mm."""
    up = body.axes.up_vector
    height = body.position(body.landmarks["bust point left"]) @ up
    length = 0.0
    for piece in bm.make_pattern(body, "bodice", ease=ease).pieces:
        mesh = piece.flat.mesh
        skin = evaluate(body.control_points[mesh.places.patch], mesh.places.parameters)
        line = level_line(mesh, skin @ up - height)
        length += line.measured(piece.flat.positions) if line else 0.0
    # Both pieces are halves.
    return 2000.0 * body.unit.meters * length


def on_skin(body: bm.Atlas) -> float:
    """The level section round the trunk at the bust, in mm."""
    at = body.position(body.landmarks["bust point left"])
    loop = plane_section(body, Plane(at, body.axes.up_vector)).nearest(at)
    return 1000.0 * body.unit.meters * loop.length


if __name__ == "__main__":
    print(f"{'body':18}{'skin':>8}{'pieces':>8}{'wider':>8}{'with ease':>11}{'wider':>8}  (mm)")
    for name in BODIES:
        sample = bm.load_sample(name)
        skin, bare, eased = on_skin(sample), in_pieces(sample, None), in_pieces(sample, EASE)
        print(
            f"{name:18}{skin:8.1f}{bare:8.1f}{bare - skin:+8.1f}{eased:11.1f}{eased - skin:+8.1f}"
        )
