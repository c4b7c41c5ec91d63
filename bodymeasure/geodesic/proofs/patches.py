"""The patches that the paths of a solution lie on, kept for proofs that are made when asked for."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.numerics.array_libraries import to_numpy
from bodymeasure.geodesic.proofs.bounds import (
    Bounds,
    SampledPaths,
    bounds_of,
    sample_paths,
)
from bodymeasure.geodesic.proofs.curvature import CurvatureBounds
from bodymeasure.geodesic.proofs.shortest import (
    are_shortest,
    bounds_for_paths,
    has_little_curvature,
)
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

# Samples take some 25 kB a path: so many are taken at once.
TOGETHER = 4096


@dataclass(frozen=True, eq=False)
class PatchesOfPaths:
    """Polynomial patches of about size 1, and which of them each path lies on.

    Parameters
    ----------
    control_points : array, shape (patches, m + 1, n + 1, 3)
        An array of the library that the user gave.
    surface_of : ndarray of int, shape (paths,)
    scale : ndarray, shape (paths,)
        The factors that take lengths on these patches to the user's unit.
    """

    control_points: Any
    surface_of: Ints
    scale: Array

    @cached_property
    def nets(self) -> Array:
        """The control points as an array of numpy's."""
        return to_numpy(self.control_points)

    @cached_property
    def surfaces(self) -> BezierSurfaces:
        """The patches as surfaces that the solver can use."""
        return BezierSurfaces(self.nets)

    def take(self, paths: Ints) -> "PatchesOfPaths":
        """Return the patches of some of the paths, which do not keep the others in memory."""
        needed, surface_of = np.unique(self.surface_of[paths], return_inverse=True)
        return PatchesOfPaths(self.nets[needed], surface_of.reshape(-1), self.scale[paths])

    def curvature(self, lengths: Array) -> CurvatureBounds:
        """Return bounds of the curvature of these patches, around paths of given lengths.

        Parameters
        ----------
        lengths : ndarray, shape (paths,)
            Upper bounds in the user's unit; NaN where there is no path.
        """
        return bounds_for_paths(self.nets, self.surface_of, lengths / self.scale)

    def prove_shortest(self, curvature: CurvatureBounds, lengths: Array) -> Bools:
        """Return which paths are proven to be the only shortest ones on their patches."""
        return are_shortest(curvature, lengths / self.scale)

    def bounds(self, batches: Sequence[PathBatch], curvature: CurvatureBounds) -> Bounds:
        """Return bounds of the shortest paths' lengths, in the user's unit.

        Parameters
        ----------
        batches : sequence of PathBatch
            All paths, by trial space.
        curvature : CurvatureBounds
            Of the patches, around these paths.
        """
        result = np.full((2, len(self.scale)), np.nan)
        k = np.where(has_little_curvature(curvature), curvature.curvature, np.nan)
        for batch in _in_parts(batches):
            here, (first, last) = batch.problems, (batch.values[:, :, end] for end in (0, -1))
            surface = self.surfaces.take(self.surface_of[here])
            # Unlike `positions`, this keeps all digits of patches that are far from the origin.
            ends = surface.jet(np.stack([first, last], axis=1), 0)[0]
            distance = np.linalg.norm(ends[..., 1] - ends[..., 0], axis=0)
            if batch.contacts:
                # Along an edge, paths are curved where the edge is.
                unknown = np.full(len(here), np.nan)
                sampled = SampledPaths(batch.length.raw, unknown)
            else:
                sampled = sample_paths(surface, batch.space, batch.values)
            result[:, here] = bounds_of(batch.length.raw, sampled, k[here], distance)
        return Bounds(*(result * self.scale))


def _in_parts(batches: Sequence[PathBatch]) -> Iterator[PathBatch]:
    for batch in batches:
        count = len(batch.problems)
        for first in range(0, count, TOGETHER):
            yield batch.take(np.arange(first, min(first + TOGETHER, count)))
