"""pyvista's readers of atlases: ``pyvista.read("body.atlas")``."""

from os import PathLike
from pathlib import Path
from typing import Any

import pyvista as pv

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.formats import read_atlas
from bodymeasure.formats.registry import format_of
from bodymeasure.plugin.remembered import SEGMENTS, mesh_of


def read_as_mesh(
    path: str | PathLike[str],
    *,
    unit: str | None = None,
    segments: int = SEGMENTS,
    **others: Any,
) -> pv.PolyData:
    """Read an atlas as a mesh that remembers it.

    Parameters
    ----------
    path : path-like
    unit : str, optional
        Unit of the coordinates, for formats that do not state it. Without it, lengths are in the
        file's own unit, and say so.
    segments : int
        Steps along a patch's side.

    Raises
    ------
    InputError
        If the file is no atlas, or an option is unknown.
    """
    unknown = sorted(others)
    if unknown:
        raise InputError(
            f"reading {path}: unknown option {unknown[0]!r}; expected unit or segments"
        )
    keeps_unit = "unit" in format_of(Path(path)).keeps
    # The unit is not needed to show the mesh, or to compare lengths with one another.
    given = unit if unit is not None or keeps_unit else Unit.M
    atlas = read_atlas(path, unit=given)
    return mesh_of(atlas, unit_known=keeps_unit or unit is not None, segments=segments)
