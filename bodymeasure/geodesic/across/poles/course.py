"""The course of a path: where it runs on each patch, before it is refined."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.pieces.refine import RefinedPath

# Points at which each piece is sampled.
SAMPLES = np.linspace(0.0, 1.0, 33)
# Two places on a seam that are this near to each other are one.
SAME = 1e-6


@dataclass(frozen=True, eq=False)
class Course:
    """A path that is given by points of it.

    Parameters
    ----------
    pieces : tuple of (int, ndarray of shape (k, 2))
        The patch of each piece and points of it, with its ends.
    crossings : tuple of Crossing
        The step over the seam between each piece and the next.
    """

    pieces: tuple[tuple[int, Array], ...]
    crossings: tuple[Crossing, ...]

    @property
    def ends(self) -> tuple[AtlasPoint, AtlasPoint]:
        """The start and the end."""
        (first, points), (last, others) = self.pieces[0], self.pieces[-1]
        return AtlasPoint(first, *points[0].tolist()), AtlasPoint(last, *others[-1].tolist())

    def length(self, atlas: Atlas) -> float:
        """Return about how long the path is, in the atlas's unit."""
        positions = (evaluate(atlas.control_points[patch], x) for patch, x in self.pieces)
        return sum(float(np.linalg.norm(np.diff(x, axis=0), axis=1).sum()) for x in positions)


def course_of(neighbors: Neighbors, path: AtlasPath) -> Course | None:
    """Return the course of a path; None if it does not cross one seam at a time."""
    waiting = list(path.crossings)
    crossings: list[Crossing] = []
    pieces: list[tuple[int, Array]] = []
    before = path.points[0]
    for piece in path.pieces:
        points = piece.space.functions.values(SAMPLES) @ piece.values.T
        # The ends are exactly on their seams and poles.
        points[[0, -1]] = piece.values[:, [0, -1]].T
        points = np.clip(points, 0.0, 1.0)
        if pieces and waiting and _are_near(waiting[0].after, piece.end(0)):
            crossing = _crossing(neighbors, waiting[0].before, waiting[0].after)
            if crossing is None or not _are_near(waiting[0].before, before):
                return None
            crossings.append(crossing)
            pieces.append((piece.patch, points))
            del waiting[0]
        elif pieces and pieces[-1][0] == piece.patch:
            pieces[-1] = (piece.patch, np.vstack([pieces[-1][1], points[1:]]))
        elif pieces:
            return None
        else:
            pieces.append((piece.patch, points))
        before = piece.end(-1)
    return Course(tuple(pieces), tuple(crossings)) if pieces and not waiting else None


def _crossing(neighbors: Neighbors, before: AtlasPoint, after: AtlasPoint) -> Crossing | None:
    """Return the step over a seam between two places."""
    near = (step for step in neighbors.steps(before) if _are_near(step.place, after))
    return next((step.crossing for step in near), None)


def _are_near(place: AtlasPoint, other: AtlasPoint) -> bool:
    apart = max(abs(place.u - other.u), abs(place.v - other.v))
    return place.patch == other.patch and apart < SAME


def course_along(refined: RefinedPath) -> Course:
    """Return the course of a path that was refined, without the cuts within its patches."""
    route = refined.route
    points = refined.values @ refined.problem.space.functions.values(SAMPLES).T
    points[:, :, [0, -1]] = refined.values[:, :, [0, -1]]
    points = np.clip(points, 0.0, 1.0)
    pieces: list[tuple[int, Array]] = [(route.patches[0], points[0].T)]
    crossings: list[Crossing] = []
    for crossing, here in zip(route.crossings, points[1:], strict=True):
        if crossing.within is None:
            pieces.append((crossing.to_patch, here.T))
            crossings.append(crossing)
        else:
            patch, before = pieces[-1]
            pieces[-1] = (patch, np.vstack([before, here.T[1:]]))
    return Course(tuple(pieces), tuple(crossings))
