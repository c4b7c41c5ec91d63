"""Bodies as a fit to a scan returns them, with the numbers that the fit states."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from bodymeasure import Atlas, LandmarkFound, LandmarkOrigin, ScanFit

# In meters: what a fit states of carried landmarks, and of the surface.
LANDMARKS, SURFACE = 0.005, 0.0006


def scanned(atlas: Atlas, uncovered: Sequence[int] = (), *, landmarks: float = LANDMARKS) -> Atlas:
    """An atlas with a fit to a scan that shows all but some of its patches."""
    coverage, distance = np.ones(len(atlas)), np.full(len(atlas), SURFACE)
    coverage[list(uncovered)], distance[list(uncovered)] = 0.0, np.nan
    found = LandmarkFound(LandmarkOrigin.CARRIED, landmarks)
    scan = ScanFit(
        coverage,
        distance,
        dict.fromkeys(atlas.landmarks, found),
        ("The file's unit is mm.",),
        ("The scan has holes.",) if len(uncovered) else (),
    )
    return replace(atlas, scan=scan)
