"""How wide the closed bodice is at the bust and at the waist, against the body.

Edges of pieces are exact; inside of a piece, the cloth gives, and this says by how much. The waist
is that of the bodice's seam, which dips toward the back. With ``--bridge``, the cloth bridges
hollows, and the bust is that of the tape.
"""

import sys

import bodymeasure as bm
from bodymeasure.bezier import evaluate
from bodymeasure.pattern.flat.level_line import level_line
from bodymeasure.section import Plane, convex_hull, plane_section

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
EASE = {"bust": 0.04, "waist": 0.02}


def at_bust(pattern: bm.Pattern) -> float:
    """The line at the bust's level round the whole body, as it is in the pieces, in mm."""
    body = pattern.atlas
    up = body.axes.up_vector
    height = body.position(body.landmarks["bust point left"]) @ up
    length = 0.0
    for piece in pattern.pieces:
        mesh = piece.flat.mesh
        skin = evaluate(body.control_points[mesh.places.patch], mesh.places.parameters)
        line = level_line(mesh, skin @ up - height)
        length += line.measured(piece.flat.positions) if line else 0.0
    # Both pieces are halves.
    return 2000.0 * body.unit.meters * length


def at_waist(pattern: bm.Pattern) -> tuple[float, float]:
    """The waist's seam round the whole body, on the skin and in the pieces, in mm."""
    edges = [piece.edge("waist") for piece in pattern.pieces]
    scale = 2000.0 * pattern.atlas.unit.meters
    return scale * sum(edge.skin_length for edge in edges), scale * sum(e.length for e in edges)


def on_body(body: bm.Atlas, bridge: bool) -> float:
    """The level section round the trunk at the bust, or the tape round it, in mm."""
    at = body.position(body.landmarks["bust point left"])
    loop = plane_section(body, Plane(at, body.axes.up_vector)).nearest(at)
    return 1000.0 * body.unit.meters * (convex_hull(loop).length if bridge else loop.length)


def main() -> None:
    bridge = "--bridge" in sys.argv
    print(f"{'body':18}{'bust':>8}{'pieces':>8}{'wider':>8}{'with ease':>11}{'wider':>8}", end="")
    print(f"{'waist':>10}{'with ease':>11}{'wider':>8}  (mm)")
    for name in BODIES:
        body = bm.load_sample(name)
        bare, eased = (
            bm.make_pattern(body, "bodice", ease=ease, bridge=bridge) for ease in (None, EASE)
        )
        bust, own, wide = on_body(body, bridge), at_bust(bare), at_bust(eased)
        print(f"{name:18}{bust:8.1f}{own:8.1f}{own - bust:+8.1f}{wide:11.1f}", end="")
        waist, grown = at_waist(eased)
        print(f"{wide - bust:+8.1f}{waist:10.1f}{grown:11.1f}{grown - waist:+8.2f}")


if __name__ == "__main__":
    main()
