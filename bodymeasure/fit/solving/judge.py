"""Whether a fitted body is that of the scan, and where the scan has nothing to say of it."""

from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.scan_fit import LEAST_COVERAGE
from bodymeasure.bezier import derivatives
from bodymeasure.errors import FitError
from bodymeasure.fit.model import body_model, limit_matrix, skeleton
from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.refined import refined
from bodymeasure.fit.solving.state import State, normals_of, surface_of
from bodymeasure.fit.solving.step import AGREE, SPREADS

# A place of the body has scan if there is some within this distance in meters.
NEAR = 0.012
# A point of the scan is explained if the body is within this distance in meters.
EXPLAINED = 0.02
# Samples along a side of each patch.
SAMPLES = 5
# Limits below which there is no body in the scan, and below which a user should look. Fits that
# were right explained 97 to 100 % of the scan and found scan at 99 to 100 % of the body; an arm
# that was missing took 6 %, and scans in which no body was found had less than half.
LEAST_COVERED, COVERED = 0.9, 0.99
LEAST_EXPLAINED, WELL_EXPLAINED = 0.85, 0.95
# In standard deviations; of 200 held-out bodies the largest was 5.1, and 4.3 was that of 5 %.
LARGEST, LARGE = 6.5, 4.5
# Statures of adults, in meters.
STATURES = (1.35, 2.1)
# The fault of the start beyond which no body was found: right ones had 0.1 to 0.6.
HOPELESS = 1.2


@dataclass(frozen=True)
class Scores:
    """How well a body fits a scan.

    Parameters
    ----------
    covered : float
        Share of the vertices, where the atlas is, that have scan within 12 mm.
    explained : float
        Share of the scan that has the body within 20 mm.
    rms_before, rms : float
        RMS distance of the scan from the body before and after it followed the scan's surface,
        where they are within 20 mm; in meters.
    largest_coefficient : float
        In standard deviations of the space of bodies.
    largest_angle : float
        Largest turn of a joint, in its standard deviations.
    stature : float
        In meters, in the A-pose.
    noise : float
        Standard deviation of the noise of the scan's vertices, in meters.
    start : float
        How badly the coarse start fitted, from 0 to 2.
    """

    covered: float
    explained: float
    rms_before: float
    rms: float
    largest_coefficient: float
    largest_angle: float
    stature: float
    noise: float
    start: float


class Found(NamedTuple):
    """What the steps of a fit found.

    Parameters
    ----------
    start : float
        The fault of the coarse start.
    before : ndarray, shape (13380, 3)
        Vertices of the body of the space.
    noise : float
        Of the scan's vertices, in meters.
    """

    start: float
    before: Array
    noise: float


@dataclass(frozen=True, eq=False)
class Coverage:
    """Where an atlas has scan.

    Parameters
    ----------
    share : ndarray, shape (376,)
        Share of each patch that has scan within 12 mm.
    distance : ndarray, shape (376,)
        RMS distance of each patch from the scan where it has some; NaN where it has none.
    """

    share: Array
    distance: Array

    @property
    def uncovered(self) -> Ints:
        """The patches of which less than half has scan: they take their shape from the bodies."""
        return np.flatnonzero(self.share < LEAST_COVERAGE)


def coverage_of(atlas: Atlas, cloud: Cloud) -> Coverage:
    """Return where an atlas, in the frame of the cloud, has scan."""
    side = (np.arange(SAMPLES) + 0.5) / SAMPLES
    places = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1).reshape(-1, 2)
    found = derivatives(atlas.control_points, np.tile(places, (len(atlas), 1, 1)), 1)
    points = found[..., 0, 0, :]
    crossed = np.cross(found[..., 1, 0, :], found[..., 0, 1, :])
    normals = crossed / np.maximum(np.linalg.norm(crossed, axis=-1, keepdims=True), 1e-15)
    gaps = gaps_to(points.reshape(-1, 3), normals.reshape(-1, 3), cloud).reshape(len(atlas), -1)
    known = np.isfinite(gaps)
    squares = np.where(known, gaps, 0.0) ** 2
    counts = known.sum(axis=1)
    mean = np.where(counts > 0, squares.sum(axis=1) / np.maximum(counts, 1), np.nan)
    return Coverage(known.mean(axis=1), np.sqrt(mean))


def gaps_to(points: Array, normals: Array, cloud: Cloud) -> Array:
    """Return the signed distances of points from a scan, positive outside; NaN without scan."""
    distance, nearest = cloud.tree.query(points, distance_upper_bound=NEAR)
    known = np.isfinite(distance)
    nearest = np.where(known, nearest, 0)
    agree = np.einsum("nd,nd->n", cloud.normals[nearest], normals) > AGREE
    heights = np.einsum("nd,nd->n", points - cloud.points[nearest], cloud.normals[nearest])
    return np.where(known & agree, heights, np.nan)


def distances_of(vertices: Array, cloud: Cloud) -> Array:
    """Return the signed distances of the limit positions from the scan, shape (13380,)."""
    points = limit_matrix() @ vertices
    return gaps_to(points, normals_of(points), cloud)


def explained_by(vertices: Array, cloud: Cloud) -> tuple[float, float]:
    """Return the share of a scan that has the body near it, and the RMS distance of that."""
    points = refined().matrix @ vertices
    distance, nearest = cKDTree(points).query(cloud.points, distance_upper_bound=EXPLAINED)
    known = np.isfinite(distance)
    steps = points[np.where(known, nearest, 0)] - cloud.points
    heights = np.einsum("nd,nd->n", steps, cloud.normals)[known]
    rms = float(np.sqrt(np.mean(heights**2))) if known.any() else float("nan")
    return float(known.mean()), rms


def scores_of(state: State, found: Found, after: Array, cloud: Cloud) -> Scores:
    """Return how well a body fits.

    Parameters
    ----------
    state : State
    found : Found
    after : ndarray, shape (13380, 3)
        Vertices that follow the scan's surface.
    cloud : Cloud
    """
    known = np.isfinite(distances_of(after, cloud))
    explained, rms = explained_by(after, cloud)
    angles = [
        float(np.linalg.norm(state.rotations[skeleton().number(name)])) / spread
        for name, spread in SPREADS.items()
    ]
    at_rest = surface_of(State(state.coefficients, np.zeros((31, 3)), np.zeros(3))).points
    return Scores(
        covered=float(known[_inside()].mean()),
        explained=explained,
        rms_before=explained_by(found.before, cloud)[1],
        rms=rms,
        largest_coefficient=float(np.abs(state.coefficients).max()),
        largest_angle=max(angles),
        stature=float(np.ptp(at_rest[:, 2])),
        noise=found.noise,
        start=found.start,
    )


def refuse_hopeless(start: float) -> None:
    """Raise an error if no body was found in a scan to begin with."""
    if start > HOPELESS:
        raise FitError(
            f"no body was found in the mesh: the best start fits badly ({start:.2f} of 2, and a "
            f"body's at most {HOPELESS:g}); expected one person, standing, in meters after the "
            "unit is applied; check the unit, say which way is up and which way the person looks, "
            "and cut away all else"
        )


def refuse(scores: Scores) -> None:
    """Raise an error that says what is wrong if a fitted body is not that of the scan."""
    low, high = STATURES
    if not low <= scores.stature <= high:
        raise FitError(
            f"the fitted body is {scores.stature:.2f} m tall; expected an adult of {low:g} to "
            f"{high:g} m; check the unit of the file (--file-unit), and that the mesh is one of a "
            "standing person and of nothing else"
        )
    if scores.covered < LEAST_COVERED:
        raise FitError(
            f"only {scores.covered:.0%} of the fitted body has scan within {NEAR * 1e3:g} mm; "
            f"expected at least {LEAST_COVERED:.0%} of one person, standing; check the unit, say "
            "which way is up and which way the person looks, or scan what is missing"
        )
    if scores.explained < LEAST_EXPLAINED:
        raise FitError(
            f"the fitted body explains only {scores.explained:.0%} of the mesh; expected at least "
            f"{LEAST_EXPLAINED:.0%}; cut away what is not the body (other people, furniture), or "
            "say which way is up and which way the person looks"
        )
    if scores.largest_coefficient > LARGEST:
        raise FitError(
            f"the fitted body's shape is {scores.largest_coefficient:.1f} standard deviations from "
            f"the mean; expected at most {LARGEST:g}; check the unit, and that the mesh is one of "
            "a standing adult with little on"
        )


def warnings_of(scores: Scores, atlas: Atlas, uncovered: Ints) -> tuple[str, ...]:
    """Return what a user should know of a body that was not refused, in sentences."""
    result = []
    if len(uncovered):
        names = [atlas.patch_names[number] for number in uncovered]
        regions = list(dict.fromkeys(atlas.regions[number] for number in uncovered))
        result.append(
            f"The scan does not show {len(uncovered)} of {len(atlas)} patches, in "
            f"{', '.join(regions)}; their shape is a guess: {', '.join(names)}."
        )
    if scores.covered < COVERED:
        result.append(f"Of the body, {scores.covered:.1%} has scan; with a whole scan, 99 % have.")
    if scores.explained < WELL_EXPLAINED:
        result.append(
            f"The body explains {scores.explained:.0%} of the mesh; look at the rest: it may be "
            "clothes, hair or things that are not the body."
        )
    if scores.largest_coefficient > LARGE:
        result.append(
            f"The shape is {scores.largest_coefficient:.1f} standard deviations from the mean "
            "body; check the unit and the result."
        )
    return tuple(result)


@cache
def _inside() -> Ints:
    """The vertices of the part of the body that the atlas covers."""
    return np.unique(body_model().quads[body_model().covered])
