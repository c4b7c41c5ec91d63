"""Files of paths, by their extensions."""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure.arguments import file_path, shown
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError
from bodymeasure.files import write_bytes
from bodymeasure.geodesic import AtlasPath
from bodymeasure.mesh.curves.curve import Curve, curve_of
from bodymeasure.mesh.curves.rhino import to_rhino
from bodymeasure.mesh.curves.step import to_step
from bodymeasure.mesh.curves.texts import to_json, to_obj, to_svg
from bodymeasure.mesh.path import MeshPath

_WRITERS: dict[str, Callable[[Sequence[Curve], Atlas], bytes]] = {
    ".3dm": lambda curves, atlas: to_rhino(curves, atlas.unit),
    ".step": lambda curves, atlas: to_step(curves, atlas.unit),
    ".stp": lambda curves, atlas: to_step(curves, atlas.unit),
    ".obj": lambda curves, _atlas: to_obj(curves),
    ".json": lambda curves, atlas: to_json(curves, atlas.unit),
    ".svg": lambda curves, atlas: to_svg(curves, atlas.unit, atlas.axes),
}


def write_paths(
    path: str | PathLike[str],
    atlas: Atlas,
    paths: Mapping[str, AtlasPath | MeshPath | ArrayLike],
) -> None:
    """Write paths as curves for CAD and drawing programs; the extension decides the format.

    Parameters
    ----------
    path : path-like
        Ends in ``.3dm`` (Rhino), ``.step`` or ``.stp``, ``.obj``, ``.json`` or ``.svg``.
    atlas : Atlas
        The atlas on which the paths are; files are in its unit. STEP has no inches, which become
        millimeters, as all units do in SVG.
    paths : mapping of str to AtlasPath, MeshPath or array_like of shape (k, 3)
        The paths by name; points are in the atlas's unit.

    Raises
    ------
    InputError
        If the extension is another, a path is not one, none has a length, or the file cannot be
        written.
    MissingExtraError
        If it is a ``.3dm`` file and rhino3dm is not installed.

    Notes
    -----
    A path over the smooth surface becomes a cubic spline within 1e-7 of its length; other paths are
    straight from point to point. OBJ has chains of points only. SVG is the front view at full size.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> with TemporaryDirectory() as folder:
    ...     bm.write_paths(Path(folder, "paths.step"), body, {"nape to bust": path})
    ...     "B_SPLINE_CURVE_WITH_KNOTS('nape to bust'" in Path(folder, "paths.step").read_text()
    True
    """
    path = file_path(path)
    require_atlas(atlas)
    if not isinstance(paths, Mapping):
        raise InputError(f"paths are {shown(paths)}; expected paths by their names, as in a dict")
    require_path_suffix(path)
    curves = [curve_of(name, given, atlas.unit) for name, given in paths.items()]
    write_curves(path, atlas, curves)


def require_path_suffix(path: Path) -> None:
    """Raise an InputError unless a name ends as files of paths do."""
    if path.suffix.lower() not in _WRITERS:
        raise InputError(f"{path}: expected a name that ends in one of {', '.join(_WRITERS)}")


def write_curves(path: Path, atlas: Atlas, curves: Sequence[Curve]) -> None:
    """Write curves on an atlas to a file, as `write_paths` does; those of no length are left out.

    Raises
    ------
    InputError
        If none has a length, or the file cannot be written.
    """
    drawn = [curve for curve in curves if np.ptp(curve.control_points, axis=0).any()]
    if not drawn:
        raise InputError(f"{path}: there is no path with a length to write")
    write_bytes(path, _WRITERS[path.suffix.lower()](drawn, atlas))
