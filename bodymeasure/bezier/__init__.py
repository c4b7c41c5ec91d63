"""Pure functions of arrays on tensor product Bezier patches; batch axes lead.

Control points have shape ``(..., m + 1, n + 1, 3)``: axis -3 runs with u, axis -2 with v.
"""

from bodymeasure.bezier.bernstein import bernstein, bernstein_values
from bodymeasure.bezier.degree import elevate
from bodymeasure.bezier.evaluate import derivatives, evaluate
from bodymeasure.bezier.split import restrict, split

__all__ = [
    "bernstein",
    "bernstein_values",
    "derivatives",
    "elevate",
    "evaluate",
    "restrict",
    "split",
]
