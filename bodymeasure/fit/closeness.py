"""How close a mapped body is to the mesh that it was mapped from."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.fit.model import limit_matrix, skeleton
from bodymeasure.fit.scan import Scan
from bodymeasure.fit.solving.cloud import cloud_of
from bodymeasure.fit.solving.judge import (
    Coverage,
    Scores,
    coverage_of,
    distances_of,
    explained_by,
    warnings_of,
)
from bodymeasure.fit.solving.step import SPREADS
from bodymeasure.fit.topology import Gives, Posture, Topology


class Closeness(NamedTuple):
    """How close a body is to its mesh.

    Parameters
    ----------
    coverage : Coverage
        Of the atlas's patches.
    distance : ndarray, shape (13380,)
        Signed distances of the vertices' limits from the mesh, NaN where it shows nothing.
    scores : Scores
    warnings : tuple of str
    """

    coverage: Coverage
    distance: Array
    scores: Scores
    warnings: tuple[str, ...]


def closeness_of(
    vertices: Array, atlas: Atlas, scan: Scan, topology: Topology, posture: Posture
) -> Closeness:
    """Return how close a mapped body is to its mesh.

    Where the mesh is the control mesh of the body's surface, that surface is the person, and its
    mesh lies outside of it by right. Where the surface is to be that of the mesh, the distances are
    measured, since a correspondence may leave parts out, and faces do not bend.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        In the frame of the atlas.
    atlas : Atlas
    scan : Scan
        The mesh in that frame.
    topology : Topology
    posture : Posture
    """
    if topology.gives is Gives.VERTICES:
        same = np.full(len(atlas), topology.accuracy)
        coverage = Coverage(np.ones(len(atlas)), same)
        scores = _scores(vertices, posture, (1.0, 1.0, topology.accuracy))
        return Closeness(coverage, np.zeros(len(vertices)), scores, ())
    cloud = cloud_of(scan.vertices, scan.triangles)
    coverage = coverage_of(atlas, cloud)
    explained, rms = explained_by(vertices, cloud)
    scores = _scores(vertices, posture, (float(coverage.share.mean()), explained, rms))
    warnings = warnings_of(scores, atlas, coverage.uncovered)
    return Closeness(coverage, distances_of(vertices, cloud), scores, warnings)


def _scores(vertices: Array, posture: Posture, found: tuple[float, float, float]) -> Scores:
    surface = limit_matrix() @ posture.a_pose(vertices)
    angles = np.linalg.norm(posture.rotations, axis=1)
    turns = [angles[skeleton().number(joint)] / spread for joint, spread in SPREADS.items()]
    covered, explained, rms = found
    return Scores(
        covered=covered,
        explained=explained,
        rms_before=posture.residual,
        rms=rms,
        largest_coefficient=float(np.abs(posture.coefficients).max()),
        largest_angle=float(max(turns)),
        stature=float(np.ptp(surface[:, 2])),
        noise=0.0,
        start=0.0,
    )
