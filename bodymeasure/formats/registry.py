"""All formats of atlases, and the extensions of their files.

A new format is a module of its own and one entry of `FORMATS`.
"""

import warnings
from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import NamedTuple

from bodymeasure.arguments import file_path, require_kind, several
from bodymeasure.atlas import Atlas, Axes, Unit
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError, ReadWarning
from bodymeasure.files import read_bytes, write_bytes
from bodymeasure.formats import atlas_json, bez, bpt, geomdl, npz, patches
from bodymeasure.formats.foreign import cad, rhino
from bodymeasure.formats.groups import select_groups
from bodymeasure.formats.obj import mesh as obj_mesh
from bodymeasure.formats.obj import read as obj
from bodymeasure.formats.obj import surfaces as obj_surfaces
from bodymeasure.formats.obj.approximate import approximate
from bodymeasure.formats.obj.mesh import Faces
from bodymeasure.formats.obj.triangles import TRIANGLE_MESHES, no_atlas, require_quads
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.patches import ReadPatches

Read = Callable[[bytes, str], Atlas | ReadPatches | Faces]


class Format(NamedTuple):
    """A file format.

    Parameters
    ----------
    title : str
        The words by which errors name it.
    extensions : tuple of str
        Extensions of files that are read and written in this format.
    read : callable
        Turns the content and the name of a file into an atlas, or into patches or faces without a
        unit.
    write : callable, optional
        Turns an atlas into the content of a file.
    keeps : frozenset of str
        What a file holds besides the geometry: any of "unit" (with the axes), "names", "regions",
        "approximation", "faces", "scan", "given" (lengths) and "landmarks" (with the atlas's name
        and provenance).
    """

    title: str
    extensions: tuple[str, ...]
    read: Read
    write: Callable[[Atlas], bytes] | None
    keeps: frozenset[str] = frozenset()


ALL = frozenset(
    {"unit", "names", "regions", "landmarks", "approximation", "faces", "scan", "given"}
)
FORMATS = {
    "atlas": Format("a bodymeasure atlas", (".atlas",), atlas_json.read, atlas_json.write, ALL),
    "npz": Format("an .npz file", (".npz",), npz.read, npz.write, ALL),
    "bpt": Format("a BPT file", (".bpt",), bpt.read, bpt.write),
    "bez": Format("a Geomview Bezier file", (".bez", ".bbp"), bez.read, bez.write),
    "obj": Format(
        "a Wavefront OBJ file",
        (".obj",),
        obj.read,
        obj_surfaces.write,
        frozenset({"names", "regions"}),
    ),
    "obj-surfaces": Format("a Wavefront OBJ file", (), obj_surfaces.read, None),
    "obj-mesh": Format("a Wavefront OBJ file", (), obj_mesh.read, None),
    "3dm": Format(
        "a Rhino file", (".3dm",), rhino.read, None, frozenset({"unit", "names", "regions"})
    ),
    "step": Format("a STEP file", (".step", ".stp"), cad.read_step, None, frozenset({"unit"})),
    "iges": Format("an IGES file", (".iges", ".igs"), cad.read_iges, None, frozenset({"unit"})),
    "geomdl": Format("geomdl's JSON", (".json",), geomdl.read, geomdl.write, frozenset({"names"})),
}
EXTENSIONS = {extension: form for form in FORMATS.values() for extension in form.extensions}


def read_atlas(
    path: str | PathLike[str],
    *,
    unit: str | None = None,
    up: str | None = None,
    front: str | None = None,
    group: str | Sequence[str] = (),
    format: str | None = None,  # noqa: A002  (what the command line calls it)
    tolerance: float | None = None,
    deviation: float | None = None,
    interpolate: bool = False,
    quads: bool = False,
) -> Atlas:
    """Read an atlas from a file; its extension decides the format.

    Parameters
    ----------
    path : path-like
        `bodymeasure docs formats` lists the formats.
    unit : Unit or str, optional
        Unit of the file's coordinates, for formats that state none; it is never guessed.
    up, front : str, optional
        Which way is up and which way the body looks, one of ``+x -x +y -y +z -z``, for formats that
        do not say; ``+z`` and ``-y`` if not given.
    group : str or sequence of str, optional
        Take only the patches of these groups (regions).
    format : str, optional
        One of `FORMATS`, instead of what the extension says.
    tolerance : float, optional
        For formats of loose patches: how far apart edges may be that are joined, in the file's
        unit. Without it, they may differ by rounding; `check_atlas` reports wider gaps.
    deviation : float, optional
        For meshes of polygons: how far the patches may lie from the mesh's Catmull-Clark surface,
        in the file's unit; the mesh is refined until they do not. Without it, a part of 1e-4 of the
        mean edge is the aim, as long as 500 patches reach it; ``inf`` leaves one patch for each
        quad.
    interpolate : bool
        For meshes of polygons: whether the surface runs through the vertices, rather than have them
        as its control points. It suits meshes whose vertices lie on a body, as those of a scan do,
        which the surface would shrink otherwise.
    quads : bool
        Whether a mesh of triangles becomes patches, too, three or more for each triangle. Without
        it, one is refused: to measure a body, fit an atlas to it.

    Returns
    -------
    Atlas
        Patches of lower degree are elevated, and B-splines cut at their knots, both exactly. A mesh
        of polygons gives patches of its approximate Catmull-Clark surface, one for each quad or, of
        small meshes, more; how well they approximate it is the atlas's `approximation`.

    Raises
    ------
    InputError
        If the file is missing, unreadable or not valid, or it has no unit and none is given. The
        message names the file and the place in it. If it is a mesh of triangles, the error is a
        `TriangleMeshError`.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "body.bpt")
    ...     bm.write_atlas(bm.load_sample("paraboloid"), file)
    ...     atlas = bm.read_atlas(file, unit="cm")
    >>> len(atlas), str(atlas.unit)
    (1, 'cm')
    """
    path = file_path(path)
    options = ReadOptions.checked(unit, up, front, group, tolerance, deviation, interpolate, quads)
    # The content comes first: for a missing file or a folder, the extension does not matter.
    content = read_bytes(path)
    return decode(content, str(path), format_of(path, format), options)


def decode(content: bytes, source: str, form: Format, options: ReadOptions) -> Atlas:
    """The atlas in a file's content; `source` names the file in errors."""
    if "unit" not in form.keeps:
        # A missing unit is reported before any other fault.
        options.known_unit(source, form.title)
    read = form.read(content, source)
    axes = options.axes or Axes()
    if not isinstance(read, Atlas):
        for note in read.notes:
            warnings.warn(f"{source}: {note}", ReadWarning, stacklevel=3)
    if not isinstance(read, Faces):
        options.require_no_mesh(source)
    if isinstance(read, Atlas):
        options.require_none(source, read.unit, read.axes)
        atlas = read
    elif isinstance(read, ReadPatches):
        if read.unit is not None:
            options.require_unit(source, read.unit)
        unit = read.unit or options.known_unit(source, form.title)
        atlas = patches.assemble(read, source, unit=unit, axes=axes, tolerance=options.tolerance)
    else:
        if options.tolerance is not None:
            raise InputError(
                f"{source}: is a mesh, joined by the vertices of its faces; leave the tolerance "
                "out, and merge vertices where it was made"
            )
        unit = options.known_unit(source, form.title)
        if not options.quads:
            require_quads(read.mesh.sizes, source, unit)
        atlas = _of_mesh(read, source, unit, options)
    if not options.groups:
        return atlas
    try:
        return select_groups(atlas, options.groups)
    except InputError as error:
        raise InputError(f"{source}: {error}") from None


def _of_mesh(faces: Faces, source: str, unit: Unit, options: ReadOptions) -> Atlas:
    try:
        patches = approximate(
            faces.mesh, faces.holes, options.deviation, interpolate=options.interpolate
        )
    except InputError as error:
        raise InputError(f"{source}: {error}") from None
    return obj_mesh.assemble(faces, patches, unit=unit, axes=options.axes or Axes())


def write_atlas(
    atlas: Atlas,
    path: str | PathLike[str],
    *,
    format: str | None = None,  # noqa: A002
) -> None:
    """Write an atlas to a file; its extension decides the format.

    Coordinates are written without loss. `bodymeasure docs formats` lists what else each format has
    room for: ``.atlas`` and ``.npz`` keep everything, the others have no unit.

    Parameters
    ----------
    atlas : Atlas
    path : path-like
    format : str, optional
        One of `FORMATS`, instead of what the extension says.

    Raises
    ------
    InputError
        If the first argument is no atlas, the extension is unknown, or the file cannot be written;
        nothing half-written is left.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "body.atlas")
    ...     bm.write_atlas(bm.load_sample("paraboloid"), file)
    ...     bm.read_atlas(file).name
    'Paraboloid of revolution'
    """
    require_atlas(atlas)
    path = file_path(path)
    form = format_of(path, format, writing=True)
    assert form.write is not None
    write_bytes(path, form.write(atlas))


def read_population(path: str | PathLike[str]) -> tuple[Atlas, ...]:
    """Read all bodies of an ``.npz`` file.

    Parameters
    ----------
    path : path-like

    Returns
    -------
    tuple of Atlas
        With the same patches, in the order in which they were written.

    Raises
    ------
    InputError
        If the file is missing, unreadable or not valid.

    Examples
    --------
    >>> from dataclasses import replace
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> bodies = [body, replace(body, points=1.1 * body.points, name="A taller one")]
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "bodies.npz")
    ...     bm.write_population(bodies, file)
    ...     [body.name for body in bm.read_population(file)]
    ['Average female body, 160.5 cm', 'A taller one']
    """
    path = file_path(path)
    return npz.read_bodies(read_bytes(path), str(path))


def write_population(atlases: Sequence[Atlas], path: str | PathLike[str]) -> None:
    """Write bodies with the same patches to one ``.npz`` file, without loss.

    Parameters
    ----------
    atlases : sequence of Atlas
        They may differ in their points and names.
    path : path-like

    Raises
    ------
    InputError
        If they differ in more, or the file cannot be written.

    Examples
    --------
    >>> from dataclasses import replace
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> bodies = [body, replace(body, points=1.1 * body.points, name="A taller one")]
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "bodies.npz")
    ...     bm.write_population(bodies, file)
    ...     [body.name for body in bm.read_population(file)]
    ['Average female body, 160.5 cm', 'A taller one']
    """
    atlases = several(atlases, Atlas, "the atlases", "an Atlas")
    path = file_path(path)
    if path.suffix.lower() != ".npz":
        raise InputError(f"{path}: many bodies go into an .npz file; give a name that ends so")
    write_bytes(path, npz.write_bodies(atlases))


def format_of(path: Path, name: str | None = None, *, writing: bool = False) -> Format:
    """Return the format of a name, or else of a file's extension.

    Parameters
    ----------
    path : Path
    name : str, optional
    writing : bool
        Whether a file is to be written, which some formats do not allow.

    Raises
    ------
    InputError
        If there is none; the message lists those that there are. For meshes of triangles, the error
        is a `TriangleMeshError`.
    """
    if name is not None:
        require_kind(name, str, "the format", f"one of {', '.join(FORMATS)}")
    table, key = (EXTENSIONS, path.suffix.lower()) if name is None else (FORMATS, name)
    allowed = [each for each, form in table.items() if form.write is not None or not writing]
    if key in allowed:
        return table[key]
    if name is None and key in TRIANGLE_MESHES and not writing:
        raise no_atlas(path)
    if key in table:
        written = ", ".join(end for end, form in EXTENSIONS.items() if form.write is not None)
        raise InputError(f"{path}: this format can only be read; expected one of {written}")
    what = (
        f"{path}: {f'unknown kind of file {path.suffix!r}' if path.suffix else 'has no extension'}"
        if name is None
        else f"unknown format {name!r}"
    )
    raise InputError(f"{what}; expected one of {', '.join(allowed)}")
