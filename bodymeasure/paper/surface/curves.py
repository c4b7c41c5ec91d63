"""The curves of an atlas in Table 5, diagonals and boundary curves, as points."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import EDGES, Atlas, edge_table
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic import Method
from bodymeasure.measure import boundary_lengths, diagonals

# Number of points of each curve, which are 1.4 mm apart on the diagonals of a mannequin.
POINTS = 65


@dataclass(frozen=True, eq=False)
class AtlasCurves:
    """Curves on the patches of an atlas.

    Parameters
    ----------
    patch : tuple of str
    place : tuple of str
        ``diagonal 1``, ``side u = 0`` and so on.
    points : ndarray, shape (k, POINTS, 3)
    length : ndarray, shape (k,)
        Lengths of the curves themselves, not of the polygons; NaN where there is none.
    status : tuple of str
        The status of each length, in words.
    """

    patch: tuple[str, ...]
    place: tuple[str, ...]
    points: Array
    length: Array
    status: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.patch)

    def take(self, numbers: Ints) -> "AtlasCurves":
        """Return some of the curves."""
        return AtlasCurves(
            tuple(self.patch[i] for i in numbers),
            tuple(self.place[i] for i in numbers),
            self.points[numbers],
            self.length[numbers],
            tuple(self.status[i] for i in numbers),
        )


def diagonal_curves(atlas: Atlas, method: Method | None = None) -> AtlasCurves:
    """Return both diagonal geodesics of every patch, patch after patch.

    Where there is none, the straight line in (u, v) takes its place without a length, since a path
    that was not solved may run anywhere.
    """
    solution = diagonals(atlas, method=method, on_failure="status")
    t = np.linspace(0.0, 1.0, POINTS)
    straight = (
        solution.start[:, :, None] * (1.0 - t[:, None]) + solution.end[:, :, None] * t[:, None]
    )
    solved = np.isfinite(solution.length)[..., None, None]
    parameters = np.where(solved, solution.path(t), straight)
    points = evaluate(atlas.control_points, parameters)
    return AtlasCurves(
        patch=tuple(name for name in atlas.patch_names for _ in range(2)),
        place=("diagonal 1", "diagonal 2") * len(atlas),
        points=points.reshape(-1, POINTS, 3),
        length=solution.length.ravel(),
        status=tuple(status.sentence for status in np.asarray(solution.status).ravel()),
    )


def boundary_curves(atlas: Atlas) -> AtlasCurves:
    """Return the sides of all patches; a shared side is there once, on the lower patch."""
    _, first = np.unique(edge_table(atlas.index).edge.ravel(), return_index=True)
    patch, side = np.divmod(np.sort(first), 4)
    parameters = np.empty((len(EDGES), POINTS, 2))
    for number, edge in enumerate(EDGES):
        parameters[number, :, edge.fixed_axis] = edge.fixed_value
        parameters[number, :, 1 - edge.fixed_axis] = np.linspace(0.0, 1.0, POINTS)
    return AtlasCurves(
        patch=tuple(atlas.patch_names[i] for i in patch),
        place=tuple(f"side {EDGES[i].name}" for i in side),
        points=evaluate(atlas.control_points[patch], parameters[side]),
        length=boundary_lengths(atlas).length[patch, side],
        status=("A side's length is an integral, with no equation to solve.",) * len(patch),
    )
