"""Pairs of points through which different ways between two ends lead.

Each third of a shortest path is the shortest path between its own ends. The same holds for many a
path that is only shorter than those close to it. So with points m and n spread over the surface,
the ways start - m - n - end whose three parts are about equally long hold one near each such path,
and as the path is a local minimum, it is shorter than the ways through the neighbors of m and n.
"""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.across.routes.graph import PatchGraph

# The number of points that are spread over the region that paths can reach.
POINTS = 150
# Two parts are equally long if they differ by at most this many times the spacing of the points,
# and two points are neighbors if they are at most this many times the spacing apart.
UNEQUAL, BESIDE = 1.5, 2.0


class ViaPair(NamedTuple):
    """Two vertices of a graph, and the rough length of the way through both."""

    length: float
    first: int
    second: int


def via_pairs(graph: PatchGraph, to_start: Array, to_end: Array, reach: float) -> list[ViaPair]:
    """Return the pairs of vertices of which no neighboring pair makes a shorter way.

    The shortest way comes first.

    Parameters
    ----------
    graph : PatchGraph
    to_start, to_end : ndarray, shape (n,)
        The distances of its vertices from the two ends.
    reach : float
        The longest way that is wanted.
    """
    region = np.flatnonzero(to_start + to_end <= reach)
    if len(region) == 0:
        return []
    picks, apart, spacing = _spread(graph.steps[region][:, region])
    first, last = to_start[region][picks], to_end[region][picks]
    whole = first[:, None] + apart + last
    equal = np.abs(first[:, None] - apart) <= UNEQUAL * spacing
    equal &= np.abs(last - apart) <= UNEQUAL * spacing
    whole = np.where(equal & (whole <= reach), whole, np.inf)
    beside = apart <= BESIDE * spacing
    found = [
        ViaPair(float(whole[i, j]), int(region[picks[i]]), int(region[picks[j]]))
        for i, j in np.argwhere(np.isfinite(whole))
        if whole[i, j] <= whole[np.ix_(beside[i], beside[j])].min()
    ]
    return sorted(found)


def _spread(steps: "scipy.sparse.csr_array") -> tuple[Ints, Array, float]:
    """Vertices far from one another, their distances, and their spacing.

    Each vertex is the farthest from those before it: T. F. Gonzalez, "Clustering to minimize the
    maximum intercluster distance", Theoretical Computer Science 38 (1985).
    """
    picks, rows = [0], [scipy.sparse.csgraph.dijkstra(steps, indices=0)]
    nearest = rows[0]
    while len(picks) < POINTS:
        # A vertex to which no way leads within the region is infinitely far, and becomes a pick.
        farthest = int(np.argmax(nearest))
        if nearest[farthest] == 0.0:
            break
        picks.append(farthest)
        rows.append(scipy.sparse.csgraph.dijkstra(steps, indices=farthest))
        nearest = np.minimum(nearest, rows[-1])
    apart = np.array(rows)[:, picks]
    # Where all vertices are picked, the spacing is that of the vertices themselves.
    others = np.where(np.eye(len(picks), dtype=bool), np.inf, apart).min(axis=1)
    return np.array(picks), apart, float(nearest.max() or np.median(others))
