"""Pure functions of arrays on tensor product Bezier patches; batch axes lead.

Control points have shape ``(..., m + 1, n + 1, 3)``: axis -3 runs with u, axis -2 with v.
Those of rational patches have four coordinates, ``(w x, w y, w z, w)``.
"""

from bodymeasure.bezier.bernstein import bernstein, bernstein_values
from bodymeasure.bezier.bspline import BezierPieces, bezier_pieces
from bodymeasure.bezier.degree import elevate
from bodymeasure.bezier.evaluate import derivatives, evaluate
from bodymeasure.bezier.rational import divide, homogeneous, project, scaled
from bodymeasure.bezier.split import restrict, split

__all__ = [
    "BezierPieces",
    "bernstein",
    "bernstein_values",
    "bezier_pieces",
    "derivatives",
    "divide",
    "elevate",
    "evaluate",
    "homogeneous",
    "project",
    "restrict",
    "scaled",
    "split",
]
