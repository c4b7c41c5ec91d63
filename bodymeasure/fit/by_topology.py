"""Bodies of models with a fixed topology, mapped by correspondence: no search."""

from dataclasses import replace
from os import PathLike, fspath

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import file_path, require_kind
from bodymeasure.atlas import LandmarkFound, LandmarkOrigin, ScanFit, Unit
from bodymeasure.errors import InputError
from bodymeasure.fit.closeness import closeness_of
from bodymeasure.fit.completed import completed
from bodymeasure.fit.model import atlas_of_vertices
from bodymeasure.fit.result import FittedBody
from bodymeasure.fit.scan import Scan
from bodymeasure.fit.scan.read import check_axes, required_unit
from bodymeasure.fit.topology import (
    Gives,
    MappedBody,
    Polygons,
    Posture,
    Topology,
    known_topology,
    mapped_body,
    polygons_of,
    posture_of,
    read_polygons,
    read_topology,
    recognized,
    topology_of_fit,
    write_topology,
)
from bodymeasure.fit.topology.hm08 import SURFACES
from bodymeasure.formats.mesh_vertices import NUMBERED
from bodymeasure.threads import one_blas_thread

# RMS distance of a landmark along the skin from its vertex of the mesh, meters: 105 bodies have
# 0.42 mm. The landmarks of other topologies are as good as those of the fit that it was made from.
OF_VERTEX, OF_FIT = 0.0005, 0.006

# hm08 has 20,000 vertices at most, with colors and normals some megabytes; larger files are scans.
MOST_BYTES = 30_000_000

Mesh = str | PathLike[str] | tuple[ArrayLike, ArrayLike]


@one_blas_thread()
def map_body(
    mesh: Mesh,
    topology: str | PathLike[str] | Topology | None = None,
    *,
    file_unit: Unit | str | None = None,
    up: str | None = None,
    name: str | None = None,
) -> FittedBody:
    """Return a body of a model with a fixed topology as an atlas, without a search.

    The atlas has landmarks by rule and lengths of head, hands and feet, as that of a scan. How
    close it is to the faces of the mesh is measured, but for ``"hm08"``, of whose surface the mesh
    is the control mesh: that surface is taken for the person.

    Parameters
    ----------
    mesh : path-like or (vertices, faces)
        A body in a standing pose near the A-pose, with the vertices and faces of its model as that
        numbers them: neither split nor welded. Files are OBJ, OFF or PLY; faces have shape (m, 3)
        or (m, 4).
    topology : path-like, str or Topology, optional
        A file that `save_topology` wrote; ``"hm08"`` for MakeHuman's base mesh, with or without
        its helper geometry, and those topologies of Anny that are parts of it; or ``"hm08 faces"``,
        for a surface that is close to the mesh itself, not the smooth one within it. Without it,
        hm08 is recognized by its faces.
    file_unit : Unit or str
        Unit of the mesh's coordinates; never guessed.
    up : str, optional
        Which axis is up, one of ``+x -x +y -y +z -z``; found where not given.
    name : str, optional
        Of the atlas; that of the file if not given.

    Returns
    -------
    FittedBody

    Raises
    ------
    InputError
        If the mesh is not of the topology, or cannot be read.
    FitError
        If the body has not the size of one, is mirrored, or does not stand along `up`.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from bodymeasure.fit.model import body_model
    >>> body = bm.map_body((100 * body_model().mean, body_model().quads), file_unit="cm")
    >>> len(body.atlas), body.warnings
    (376, ())
    """
    source, label = _called(mesh)
    polygons = _polygons(mesh)
    unit = required_unit(file_unit, source, False)
    check_axes(up, None)
    chosen = _chosen(topology, polygons, source)
    found = mapped_body(polygons, chosen, unit, up=up, source=source)
    posture = posture_of(found.vertices)
    scan = _scan(polygons, found.transform, chosen, label)
    return _fitted(found, chosen, posture, scan, label if name is None else name)


@one_blas_thread()
def save_topology(
    path: str | PathLike[str], mesh: Mesh, fitted: FittedBody, *, name: str | None = None
) -> None:
    """Store the correspondence of a model's topology, made from the fit to one of its bodies.

    Parameters
    ----------
    path : path-like
        Ends in ``.npz``. The file holds no coordinates of the model.
    mesh : path-like or (vertices, faces)
        The mesh that was fitted, as `map_body` takes it: best the model's mean body.
    fitted : FittedBody
        What `fit_body` returned for it.
    name : str, optional
        Of the topology; that of the file if not given.

    Raises
    ------
    InputError
        If the mesh cannot be read, or the file not be written.
    FitError
        If the fitted body does not lie on the mesh.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> from bodymeasure.fit.model import body_model, limit_matrix
    >>> mesh = (limit_matrix() @ body_model().mean, body_model().quads)
    >>> fitted = bm.map_body(mesh, "hm08 faces", file_unit="m")
    >>> with TemporaryDirectory() as folder:
    ...     bm.save_topology(Path(folder, "model.npz"), mesh, fitted)
    ...     body = bm.map_body(mesh, Path(folder, "model.npz"), file_unit="m")
    >>> body.atlas.scan.done[0]
    "Mapped by the correspondence of the topology 'model', made from one fit."
    """
    file = file_path(path)
    require_kind(fitted, FittedBody, "fitted", "a FittedBody, as fit_body returns it")
    polygons = _polygons(mesh)
    vertices = _moved(polygons.vertices, fitted.transform)
    made = topology_of_fit(polygons, vertices, fitted.vertices, name or file.stem)
    write_topology(file, made)


def map_known(mesh: Mesh, **how: Unit | str | None) -> FittedBody | None:
    """Return a body whose topology is known by its faces as `map_body` does; None for others.

    Parameters
    ----------
    mesh : path-like or (vertices, faces)
    **how
        The other arguments of `map_body`.
    """
    known = topology_of(mesh)
    return None if known is None else map_body(mesh, known, **how)


def topology_of(mesh: Mesh) -> Topology | None:
    """Return the topology that comes with the package and that a mesh has, or None.

    Parameters
    ----------
    mesh : path-like or (vertices, faces)
        A mesh that cannot be read has none: the reader of scans says what is wrong.
    """
    if not isinstance(mesh, tuple):
        path = file_path(mesh)
        numbered = path.suffix.lower() in NUMBERED and path.is_file()
        if not numbered or path.stat().st_size > MOST_BYTES:
            return None
    try:
        return recognized(_polygons(mesh))
    except InputError:
        return None


def _moved(vertices: Array, transform: Array) -> Array:
    return np.asarray(vertices @ transform[:3, :3].T + transform[:3, 3])


def _called(mesh: Mesh) -> tuple[str, str]:
    """Return what errors call a mesh, and the name of its body."""
    if isinstance(mesh, tuple):
        return "the mesh", ""
    path = file_path(mesh)
    return fspath(path), path.stem


def _polygons(mesh: Mesh) -> Polygons:
    if not isinstance(mesh, tuple):
        return read_polygons(file_path(mesh))
    if len(mesh) != 2:
        raise InputError(f"mesh has {len(mesh)} parts; expected vertices and faces")
    return polygons_of(*mesh)


def _chosen(
    topology: str | PathLike[str] | Topology | None, mesh: Polygons, source: str
) -> Topology:
    if isinstance(topology, Topology):
        return topology
    if topology is None:
        found = recognized(mesh)
        if found is None:
            raise InputError(
                f"{source}: is of no topology that is known; give the file of its topology, made "
                "with save_topology, or fit the body as a scan"
            )
        return found
    path = file_path(topology, "the topology")
    if str(topology) in SURFACES:
        # Even if a folder of MakeHuman's has that name.
        return known_topology(str(topology), mesh, source)
    if path.suffix.lower() == ".npz" or path.exists():
        return read_topology(path)
    return known_topology(str(topology), mesh, source)


def _scan(mesh: Polygons, transform: Array, topology: Topology, name: str) -> Scan:
    """The mesh in the atlas's frame; for hm08, without what follows its body."""
    triangles = mesh.triangles
    triangles = triangles[(triangles < topology.count).all(axis=1)]
    return Scan(
        vertices=_moved(mesh.vertices, transform),
        triangles=triangles,
        plate=np.zeros(len(triangles), dtype=np.bool_),
        file_unit=Unit.M,
        up="+z",
        front="-y",
        name=name,
    )


def _fitted(
    found: MappedBody, topology: Topology, posture: Posture, scan: Scan, name: str
) -> FittedBody:
    provenance = {"source": f"mapped from {name or 'a mesh'}", "method": topology.source}
    atlas = atlas_of_vertices(found.vertices, name=name, provenance=provenance)
    close = closeness_of(found.vertices, atlas, scan, topology, posture)
    warnings = (*found.warnings, *close.warnings)
    places = OF_FIT if topology.gives is Gives.SAMPLES else OF_VERTEX
    known = {each: LandmarkFound(LandmarkOrigin.CARRIED, places) for each in atlas.landmarks}
    coverage = close.coverage
    record = ScanFit(coverage.share, coverage.distance, known, found.notes, warnings)
    # A body of which the mesh is the control mesh is taken for the person.
    distance = close.distance if topology.gives is Gives.SAMPLES else None
    return FittedBody(
        atlas=completed(replace(atlas, scan=record), found.vertices, distance=distance),
        vertices=found.vertices,
        coefficients=posture.coefficients,
        rotations=posture.rotations,
        shift=posture.shift,
        transform=found.transform,
        coverage=coverage.share,
        uncovered=coverage.uncovered,
        distance=close.distance,
        scores=close.scores,
        picked=(),
        scan=scan,
        warnings=warnings,
    )
