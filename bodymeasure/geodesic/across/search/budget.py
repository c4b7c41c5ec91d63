"""The budget of a search: work that is counted, so that its end does not depend on the machine."""

from bodymeasure.geodesic.across.pieces.refine import RefinedPath

# The work of one of Newton's steps: a part of its own, and one for each entry of the Hessian's
# blocks. A unit takes some 0.25 microseconds.
STEP, HELD = 3000.0, 20_000.0
# What a search for a path may take, about 2 s, and what one for a loop may: from the hip to the
# waist it takes a quarter of that.
PATH, LOOP = 8e6, 8e7


class Budget:
    """The work that a search may still do.

    Parameters
    ----------
    work : float
    """

    def __init__(self, work: float) -> None:
        self.left = work
        # Whether something was left undone for want of work.
        self.cut_short = False

    def spend(self, refined: RefinedPath) -> None:
        """Count the work that a refinement took."""
        degree, pieces = refined.problem.space.size, len(refined.lengths)
        self.left -= refined.steps * (STEP + pieces * degree**2)

    def spend_held(self, refined: RefinedPath) -> None:
        """Count the work of solving a path as legs and arcs."""
        self.left -= HELD * len(refined.lengths)

    def has_run_out(self) -> bool:
        """Return whether nothing is left; then what was to be done is left undone."""
        if self.left <= 0.0:
            self.cut_short = True
        return self.left <= 0.0
