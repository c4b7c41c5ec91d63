"""How far the length of a section changes when its plane moves."""

import numpy as np

from bodymeasure.bezier import derivatives
from bodymeasure.section.loop import SectionLoop

# Normals smaller than this part of the largest one are those at poles, where patches have none.
AT_POLE = 1e-6


def length_per_move(loop: SectionLoop) -> float:
    """Return a bound on the change of a curve's length for each unit that its plane moves.

    Notes
    -----
    A plane with normal p that moves by d moves each point of the curve by d w / |w|^2, where w is
    the part of p that is tangential to the surface. What lies in the plane of this lengthens the
    polygon of the curve's samples, to first order, by the sum of its steps' directions times the
    differences of these moves. Their absolute values are added here.

    Round the top of a cap of height h the length is proportional to the root of h, so that the
    bound grows without limit as h falls; half of it is the derivative.
    """
    surface, normal = loop.surface, loop.plane.normal
    jet = derivatives(surface.control_points[loop.patch], loop.parameters[:, None], order=1)
    across = np.cross(jet[:, 0, 1, 0], jet[:, 0, 0, 1])
    size = np.linalg.norm(across, axis=1, keepdims=True)
    known = size[:, 0] > AT_POLE * size.max()
    unit = across[known] / size[known]
    along = normal - unit * (unit @ normal)[:, None]
    steep = np.einsum("nc,nc->n", along, along)
    if not (steep > 0.0).all():
        return np.inf
    moves = along / steep[:, None] - normal
    positions = loop.positions[known]
    if loop.closed:
        moves, positions = (np.concatenate([each, each[:1]]) for each in (moves, positions))
    steps = np.diff(positions, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    changes = np.abs(np.einsum("nc,nc->n", steps, np.diff(moves, axis=0)))
    return 2.0 * float((changes[sizes > 0.0] / sizes[sizes > 0.0]).sum())
