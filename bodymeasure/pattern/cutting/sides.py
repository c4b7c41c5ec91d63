"""Points on the sides of patches, which both patches of a seam have to share."""

from collections.abc import Iterable

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import EDGES, EdgeTable
from bodymeasure.pattern.curves.skin_curve import Run
from bodymeasure.pattern.grid import CELLS

# Parameters of a side this near to one another are one point, found from both of its patches.
SAME = 1e-6


class SidePoints:
    """The points that curves have on the edges of an atlas, by the edges' own parameters.

    Parameters
    ----------
    table : EdgeTable
    runs : iterable of Run
        The curves.
    """

    def __init__(self, table: EdgeTable, runs: Iterable[Run]) -> None:
        self.table = table
        found: dict[int, list[float]] = {}
        for run in runs:
            for number, side in enumerate(EDGES):
                on = run.parameters[:, side.fixed_axis] == side.fixed_value
                if not on.any() or table.collapsed[run.patch, number]:
                    continue
                along = run.parameters[on, 1 - side.fixed_axis]
                edge = int(table.edge[run.patch, number])
                found.setdefault(edge, []).extend(self._turned(run.patch, number, along).tolist())
        self.on_edge = {edge: _merged(np.array(values)) for edge, values in found.items()}

    def _turned(self, patch: int, side: int, along: Array) -> Array:
        return 1.0 - along if self.table.reversed[patch, side] else along

    def of(self, patch: int, side: int) -> tuple[Array, Array]:
        """Return the points of a side: by its own parameter, and by that of its edge."""
        edge = int(self.table.edge[patch, side])
        own = self.on_edge.get(edge, np.arange(CELLS + 1) / CELLS)
        return self._turned(patch, side, own), own

    def is_cut(self, patch: int) -> bool:
        """Return whether a side of a patch has more points than the regular ones."""
        return any(int(edge) in self.on_edge for edge in self.table.edge[patch])

    def snapped(self, run: Run) -> Array:
        """Return the (u, v) of a run with its points on sides at those of the edges."""
        parameters = run.parameters.copy()
        for number, side in enumerate(EDGES):
            on = parameters[:, side.fixed_axis] == side.fixed_value
            if on.any():
                places, _ = self.of(run.patch, number)
                along = parameters[on, 1 - side.fixed_axis]
                nearest = np.abs(along[:, None] - places).argmin(axis=1)
                parameters[on, 1 - side.fixed_axis] = places[nearest]
        return parameters


def _merged(values: Array) -> Array:
    """Return the regular points of an edge and others, without those that are nearly the same."""
    regular = np.arange(CELLS + 1) / CELLS
    extra = np.sort(values)
    apart = np.abs(extra[:, None] - regular).min(axis=1) > SAME
    extra = extra[apart]
    if len(extra):
        extra = extra[np.concatenate([[True], np.diff(extra) > SAME])]
    return np.sort(np.concatenate([regular, extra]))
