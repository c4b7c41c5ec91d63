"""Shape and pose of a body, fitted from coarse to fine."""

import numpy as np

from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.progress import Report
from bodymeasure.fit.solving.state import State, even_vertices
from bodymeasure.fit.solving.step import Settings, stepped

# Components of the shape in each step, while distances that count as noise go from 5 cm to 6 mm.
COMPONENTS = (12, 12, 20, 20, 30, 30, 40, 40, 60, 60, 80, 80, 100, 120, 120)
SIGMAS = np.geomspace(0.05, 0.006, len(COMPONENTS))
PRIORS = np.geomspace(1.5, 0.03, len(COMPONENTS))
# Points of the scan and of the body that are matched in each step: many at the end, where they
# average the noise.
SCANNED = (2500,) * 9 + (6000,) * 6
VERTICES = (1700,) * 9 + (5000,) * 6


def shape_and_pose(state: State, cloud: Cloud, report: Report) -> State:
    """Return a body of the space that is near a scan everywhere.

    Parameters
    ----------
    state : State
        From `coarse_start`.
    cloud : Cloud
    report : Report
    """
    rng = np.random.default_rng(5)
    everywhere = even_vertices(12_000)
    for number, (count, sigma, prior) in enumerate(zip(COMPONENTS, SIGMAS, PRIORS, strict=True)):
        scanned = cloud.some(SCANNED[number], rng)
        vertices = rng.choice(everywhere, VERTICES[number], replace=False)
        settings = Settings(float(sigma), float(prior), count)
        state = stepped(state, cloud, settings, vertices, scanned)
        report((number + 1) / len(COMPONENTS))
    return state
