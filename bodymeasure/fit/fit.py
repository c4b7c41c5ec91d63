"""Fit a body to a scan: a triangle mesh goes in, an atlas with landmarks comes out."""

from collections.abc import Mapping
from dataclasses import replace
from os import PathLike

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import require_progress
from bodymeasure.atlas import (
    Atlas,
    LandmarkFound,
    LandmarkOrigin,
    ScanFit,
    Unit,
    closest_point,
)
from bodymeasure.errors import FitError, InputError
from bodymeasure.fit.by_topology import map_body, map_known
from bodymeasure.fit.completed import completed
from bodymeasure.fit.frame import frame_of, moved, upright
from bodymeasure.fit.model import atlas_of_vertices, posed
from bodymeasure.fit.picks import picks_of
from bodymeasure.fit.result import FittedBody
from bodymeasure.fit.scan import Scan, read_scan, scan_of
from bodymeasure.fit.scan.read import check_axes
from bodymeasure.fit.solving.cloud import cloud_of
from bodymeasure.fit.solving.coarse import coarse_start
from bodymeasure.fit.solving.grain import grain_of
from bodymeasure.fit.solving.judge import (
    Found,
    coverage_of,
    distances_of,
    refuse,
    refuse_hopeless,
    scores_of,
    warnings_of,
)
from bodymeasure.fit.solving.nonrigid import followed
from bodymeasure.fit.solving.progress import Progress, reporter
from bodymeasure.fit.solving.shape_pose import shape_and_pose
from bodymeasure.fit.topology import Topology
from bodymeasure.threads import one_blas_thread

# Points of the scan with which the fit begins.
FEW = 10_000
# RMS distances of landmarks along the skin from their places, in meters. On scans of six held-out
# bodies (tests/benchmarks/bodies/scan_charts.py) carried ones were off by 1.6 to 2.8 mm, but for
# those that no shape marks; a pick is where the user wants it, to the noise of the scan.
CARRIED, PICKED = 0.003, 0.001
UNMARKED = {
    "front waist point": 0.008,
    "side waist point left": 0.006,
    "side waist point right": 0.006,
    "side hip point left": 0.005,
    "side hip point right": 0.005,
}
# The topologies that are recognized.
KNOWN = "known"


@one_blas_thread()
def fit_body(
    mesh: str | PathLike[str] | Scan | tuple[ArrayLike, ArrayLike],
    *,
    file_unit: Unit | str | None = None,
    up: str | None = None,
    front: str | None = None,
    landmarks: Mapping[str, ArrayLike] | None = None,
    topology: str | PathLike[str] | Topology | None = KNOWN,
    name: str | None = None,
    progress: Progress | None = None,
) -> FittedBody:
    """Fit a body to a scan.

    A body of a space of bodies is posed and shaped until it is near the scan, and then follows its
    surface; a fixed map takes it to the atlas.

    Parameters
    ----------
    mesh : path-like, Scan, or (vertices, triangles)
        One standing person with little on.
    file_unit : Unit or str, optional
        Unit of the file's coordinates, or of the vertices; never guessed.
    up, front : str, optional
        Which way is up and which way the person looks, one of ``+x -x +y -y +z -z``; found where
        not given.
    landmarks : mapping of str to array_like of shape (3,), optional
        Landmarks that the user has picked on the scan, in the file's coordinates. They pull the
        fit, and take the place of the carried ones.
    topology : str, path-like or Topology, optional
        Bodies of a model with a fixed topology are mapped, not fitted: see `map_body`. As it is,
        MakeHuman's hm08 is recognized; None fits every mesh as a scan.
    name : str, optional
        Of the atlas; that of the file if not given.
    progress : callable, optional
        Called with the name of a step and the part of the whole that is done.

    Returns
    -------
    FittedBody

    Raises
    ------
    FitError
        If the mesh is not one of a body: the message says what was expected, and the remedy.
    InputError
        If the mesh cannot be read, or an argument is not what is said above.
    MissingExtraError
        If trimesh or libigl is not installed.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from bodymeasure.fit.model import body_model
    >>> # MakeHuman's mesh, which is recognized; a scan is bm.fit_body("scan.ply", file_unit="mm").
    >>> body = bm.fit_body((body_model().mean, body_model().quads), file_unit="m")
    >>> len(body.atlas), sorted(body.atlas.landmarks)[:2], body.warnings
    (376, ['back hip point', 'back neck point'], ())
    """
    require_progress(progress)
    report = reporter(progress, "reading")
    mapped = _mapped(mesh, topology, landmarks, file_unit=file_unit, up=up, name=name)
    if mapped is not None:
        report(1.0)
        return mapped
    scan = _scan(mesh, file_unit, up, front)
    report(0.5)
    source = scan.name or "the mesh"
    kept = scan.triangles[~scan.plate]
    if not len(kept):
        raise FitError(f"{source}: all of it is flat; expected the mesh of a person")
    cloud = cloud_of(scan.vertices, kept)
    picks = picks_of(landmarks, scan.file_unit.meters, cloud)
    report(1.0)
    try:
        state, start = coarse_start(
            cloud_of(scan.vertices, kept, FEW),
            scan.up_vector,
            scan.front_vector,
            reporter(progress, "finding the body"),
        )
        refuse_hopeless(start)
        state = shape_and_pose(state, cloud, reporter(progress, "shape and pose"))
        before = posed(state.coefficients, state.rotations, state.shift)
        noise, grain = grain_of(before, scan.vertices, kept)
        report = reporter(progress, "following the surface")
        after = followed(before, cloud, grain, picks.pulls, report)
        scores = scores_of(state, Found(start, before, noise), after, cloud)
        refuse(scores)
    except FitError as error:
        raise FitError(f"{source}: {error}") from None
    reporter(progress, "checking")(0.5)
    coverage = coverage_of(atlas_of_vertices(after), cloud)
    distance = distances_of(after, cloud)
    direction, found_up = upright(state, scan.up_vector)
    lowest = float((scan.vertices[np.unique(kept)] @ direction).min())
    turn, shift, grounded = frame_of(state, after, direction, lowest)
    state, vertices = moved(state, turn, shift), after @ turn.T + shift
    transform = np.eye(4)
    transform[:3] = np.column_stack([turn * scan.file_unit.meters, shift])
    atlas = _atlas(vertices, scan, scan.name if name is None else name)
    warnings = (*picks.warnings, *grounded, *warnings_of(scores, atlas, coverage.uncovered))
    done = (*scan.notes, *([found_up] if found_up else []))
    at = {each: turn @ place + shift for each, place in picks.positions.items()}
    record = ScanFit(coverage.share, coverage.distance, {}, done, warnings)
    atlas = _with_landmarks(atlas, at, record)
    atlas = completed(atlas, vertices, picked=tuple(at), distance=distance)
    reporter(progress, "checking")(1.0)
    return FittedBody(
        atlas=atlas,
        vertices=vertices,
        coefficients=state.coefficients,
        rotations=state.rotations,
        shift=state.shift,
        transform=transform,
        coverage=coverage.share,
        uncovered=coverage.uncovered,
        distance=distance,
        scores=scores,
        picked=tuple(picks.positions),
        scan=replace(
            scan,
            vertices=scan.vertices @ turn.T + shift,
            file_unit=Unit.M,
            up="+z",
            front="-y",
        ),
        warnings=warnings,
    )


def _mapped(
    mesh: str | PathLike[str] | Scan | tuple[ArrayLike, ArrayLike],
    topology: str | PathLike[str] | Topology | None,
    landmarks: object,
    **how: Unit | str | None,
) -> FittedBody | None:
    """The body by the correspondence of its topology, or None if it is to be fitted."""
    if topology is None:
        return None
    if topology == KNOWN:
        picked = landmarks is not None
        return None if picked or isinstance(mesh, Scan) else map_known(mesh, **how)
    if isinstance(mesh, Scan) or landmarks is not None:
        raise InputError(
            "a topology was given; expected the mesh as its file numbers it, and no landmarks: "
            "leave the topology out to fit the mesh as a scan"
        )
    return map_body(mesh, topology, **how)


def _scan(
    mesh: str | PathLike[str] | Scan | tuple[ArrayLike, ArrayLike],
    file_unit: Unit | str | None,
    up: str | None,
    front: str | None,
) -> Scan:
    if isinstance(mesh, Scan):
        if file_unit is not None:
            raise InputError("the scan says its unit; expected no file_unit beside it")
        up, front = up or mesh.up, front or mesh.front
        check_axes(up, front)
        return replace(mesh, up=up, front=front)
    if isinstance(mesh, tuple):
        if len(mesh) != 2:
            raise InputError(f"mesh has {len(mesh)} parts; expected vertices and triangles")
        return scan_of(*mesh, file_unit=file_unit, up=up, front=front)
    return read_scan(mesh, file_unit=file_unit, up=up, front=front)


def _atlas(vertices: Array, scan: Scan, name: str) -> Atlas:
    provenance = {
        "source": f"fitted to {scan.name or 'a mesh'}",
        "method": "bodymeasure fit: a space of bodies, posed, then moved onto the scan's surface",
    }
    return atlas_of_vertices(vertices, name=name, provenance=provenance)


def _with_landmarks(atlas: Atlas, picked: Mapping[str, Array], scan: ScanFit) -> Atlas:
    """The atlas with its picked landmarks in place of the carried ones, and how each was found."""
    places = dict(atlas.landmarks)
    found = {
        name: LandmarkFound(LandmarkOrigin.CARRIED, UNMARKED.get(name, CARRIED)) for name in places
    }
    for name, position in picked.items():
        places[name], distance = closest_point(atlas, position)
        found[name] = LandmarkFound(LandmarkOrigin.PICKED, max(distance, PICKED))
    return replace(atlas, landmarks=places, scan=replace(scan, landmarks=found))
