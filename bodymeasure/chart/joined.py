"""Paths laid end to end."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from bodymeasure.geodesic import AtlasPath, Status


def joined(paths: Sequence[AtlasPath]) -> AtlasPath:
    """One path of several, each of which begins where the one before it ends.

    Parameters
    ----------
    paths : sequence of AtlasPath
        At least one.
    """
    if len(paths) == 1:
        return paths[0]
    sizes = np.array([sum(piece.length for piece in path.pieces) for path in paths])
    before = np.cumsum(sizes) - sizes
    crossings = [
        replace(crossing, t=_share(start + crossing.t * size, sizes.sum()))
        for path, start, size in zip(paths, before.tolist(), sizes.tolist(), strict=True)
        for crossing in path.crossings
    ]
    found = all(path.pieces for path in paths)
    return AtlasPath(
        atlas=paths[0].atlas,
        points=(*paths[0].points, *(point for path in paths[1:] for point in path.points[1:])),
        length=sum(path.length for path in paths),
        raw_length=sum(path.raw_length for path in paths),
        error_estimate=sum(path.error_estimate for path in paths),
        residual=max(path.residual for path in paths),
        status=_worst([path.status for path in paths]),
        pieces=tuple(piece for path in paths for piece in path.pieces) if found else (),
        crossings=tuple(crossings) if found else (),
    )


def _share(part: float, whole: float) -> float:
    return part / whole if whole > 0.0 else 0.0


def _worst(statuses: Sequence[Status]) -> Status:
    """The first without a length, else the first that is not plainly converged."""
    failed = [status for status in statuses if not status.has_length]
    other = [status for status in statuses if status is not Status.CONVERGED]
    return (failed or other or [Status.CONVERGED])[0]
