"""The budget of a search: work that is counted, so that its end does not depend on the machine."""

from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath

# The work of one of Newton's steps: a part of its own, and one for each entry of the Hessian's
# blocks; that of reading off which edges hold a path, for each piece; and that of first routes. A
# unit takes some 0.4 microseconds.
STEP, HELD, ROUTES = 3000.0, 10_000.0, 200_000.0
# What a search for a path may take in all, some 5 s: a path down a body may need nearly all of it
# until no route is left to try. And what one for a loop may: from the hip to the waist it takes a
# quarter of that.
PATH, LOOP = 8e6, 8e7
# What a search may take on an atlas with poles, about 2 s. All parts of a path share it, and
# mostly the path past the pole is known once it is used up.
WITH_POLES = 5e6
# What may be taken beyond that to make the path at hand exact: without that there is no length.
OVERDRAFT = 1e6


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
        self.spend_steps(refined.problem, refined.steps)

    def spend_steps(self, problem: RouteProblem, steps: int) -> None:
        """Count the work of some of Newton's steps."""
        self.left -= steps * (STEP + len(problem.route.patches) * problem.space.size**2)

    def spend_on_pattern(self, refined: RefinedPath) -> None:
        """Count the work of reading off which edges hold a path."""
        self.left -= HELD * len(refined.lengths)

    def spend_on_routes(self) -> None:
        """Count the work of finding the routes between two points."""
        self.left -= ROUTES

    def is_overdrawn(self) -> bool:
        """Return whether not even the path at hand may be refined further."""
        return self.left <= -OVERDRAFT

    def has_run_out(self) -> bool:
        """Return whether nothing is left; then what was to be done is left undone."""
        if self.left <= 0.0:
            self.cut_short = True
        return self.left <= 0.0
