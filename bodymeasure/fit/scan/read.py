"""Scans from files and arrays, as users call for them."""

from os import PathLike

from numpy.typing import ArrayLike

from bodymeasure.arguments import file_path, numbers, shown, whole_numbers
from bodymeasure.atlas import Axes, Unit
from bodymeasure.atlas.axes import DIRECTIONS
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.fit.scan.clean import cleaned
from bodymeasure.fit.scan.load import Triangles, load, require_bytes
from bodymeasure.fit.scan.scan import Scan
from bodymeasure.threads import one_blas_thread

# Formats whose standard says that lengths are in meters.
IN_METERS = (".glb", ".gltf")


@one_blas_thread()
def read_scan(
    path: str | PathLike[str],
    *,
    file_unit: Unit | str | None = None,
    up: str | None = None,
    front: str | None = None,
) -> Scan:
    """Read the triangle mesh of a body from an STL, PLY, OBJ, OFF, GLB or glTF file.

    Vertices are welded by position; triangles without area, pieces with less than 3 % of the area
    and inner sides of hollow bodies are dropped; each part is turned right side out by itself;
    floors, plates and stools are recognized. The scan's `notes` say what was done.

    Parameters
    ----------
    path : path-like
    file_unit : Unit or str, optional
        Unit of the file's coordinates, which is never guessed. GLB and glTF are in meters by their
        standard, and need none.
    up, front : str, optional
        Which way is up and which way the body looks, one of ``+x -x +y -y +z -z``; a fit finds what
        is not given.

    Returns
    -------
    Scan

    Raises
    ------
    InputError
        If the file is missing, damaged, too large or holds no triangles, the unit is missing, or
        the mesh has not the size of a body. The message names the remedy.
    MissingExtraError
        If trimesh or libigl is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> mesh = bm.tessellate(bm.load_sample("female_average"), 4)
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "body.stl")
    ...     _ = mesh.to_trimesh().export(file)
    ...     scan = bm.read_scan(file, file_unit="m")
    >>> scan.notes[0].partition(" to ")[0]
    'Welded 36,096 vertices by position'
    """
    path = file_path(path)
    require_bytes(path)
    # That the file can be read comes first: nobody knows the unit of one that is missing.
    content = read_bytes(path)
    unit = required_unit(file_unit, str(path), path.suffix.lower() in IN_METERS)
    check_axes(up, front)
    found = load(content, path)
    return made(found, str(path), unit, up, front, path.stem)


@one_blas_thread()
def scan_of(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    file_unit: Unit | str | None = None,
    up: str | None = None,
    front: str | None = None,
    name: str = "",
) -> Scan:
    """Return a mesh in memory as a scan, cleaned as `read_scan` does.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
    triangles : array_like of int, shape (m, 3)
    file_unit, up, front
        As in `read_scan`; the unit is that of the vertices.
    name : str
        What the scan is called.

    Returns
    -------
    Scan

    Raises
    ------
    InputError
        If the arrays are no mesh, the unit is missing, or the mesh has not the size of a body.
    """
    source = name or "the mesh"
    unit = required_unit(file_unit, source, False)
    check_axes(up, front)
    points = numbers(vertices, "the vertices", "numbers of shape (n, 3)")
    expected = "whole numbers of vertices, of shape (m, 3)"
    corners = whole_numbers(triangles, "the triangles", expected)
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"the vertices have shape {points.shape}; expected (n, 3)")
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise InputError(f"the triangles have shape {corners.shape}; expected {expected}")
    if not len(corners):
        raise InputError("the mesh has no triangle; a cloud of points has no surface to fit to")
    if corners.min() < 0 or corners.max() >= len(points):
        raise InputError(
            f"the triangles refer to vertices {corners.min()} to {corners.max()}; expected 0 to "
            f"{len(points) - 1}"
        )
    found = Triangles(points, corners)
    return made(found, source, unit, up, front, name)


def made(
    found: Triangles, source: str, unit: Unit, up: str | None, front: str | None, name: str
) -> Scan:
    """Return the scan of a mesh in a unit; `source` names it in errors, and `name` afterwards."""
    meters = Triangles(found.vertices * unit.meters, found.triangles, found.notes)
    try:
        mesh, plate = cleaned(meters, unit)
    except InputError as error:
        raise InputError(f"{source}: {error}") from None
    return Scan(mesh.vertices, mesh.triangles, plate, unit, up, front, name, mesh.notes)


def required_unit(given: Unit | str | None, source: str, in_meters: bool) -> Unit:
    """Return the unit of a file, which the user gives unless its kind is in meters."""
    if given is not None:
        return Unit.parse(given)
    if in_meters:
        return Unit.M
    known = ", ".join(unit.value for unit in Unit)
    raise InputError(
        f"{source}: a mesh says no unit, and none was given; say in which unit its coordinates are "
        f"(one of {known}): file_unit=... in Python, --file-unit on the command line"
    )


def check_axes(up: str | None, front: str | None) -> None:
    """Raise an InputError unless axes are known, or to be found, and square to each other."""
    for name, value in (("up", up), ("front", front)):
        if value is not None and value not in DIRECTIONS:
            raise InputError(
                f"{name} is {shown(value)}; expected one of {', '.join(DIRECTIONS)}, or None to "
                "have it found"
            )
    if up is not None and front is not None:
        Axes(up, front)
