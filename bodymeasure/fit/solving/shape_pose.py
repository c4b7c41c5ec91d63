"""Shape and pose of a body, fitted from coarse to fine."""

import numpy as np

from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.progress import Report
from bodymeasure.fit.solving.state import State, even_vertices
from bodymeasure.fit.solving.step import Settings, stepped

# The steps in which distances that count as noise go from 5 cm to 6 mm, and those after them:
# landmarks that no shape marks, as the waist's, need more steps than the surface.
FIRST_STEPS, LAST_STEPS = 15, 5
# Components of the shape in each step.
COMPONENTS = (12, 12, 20, 20, 30, 30, 40, 40, 60, 60, 80, 80, 100, *(120,) * (2 + LAST_STEPS))
SIGMAS = np.append(np.geomspace(0.05, 0.006, FIRST_STEPS), np.full(LAST_STEPS, 0.006))
PRIORS = np.append(np.geomspace(1.5, 0.03, FIRST_STEPS), np.geomspace(0.03, 0.01, LAST_STEPS))
# Points of the scan and of the body that are matched in each step: many at the end, where they
# average the noise.
SCANNED = (2500,) * 9 + (6000,) * 6 + (20_000,) * LAST_STEPS
VERTICES = (1700,) * 9 + (5000,) * 6 + (12_000,) * LAST_STEPS


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
