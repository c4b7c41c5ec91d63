"""Triangle meshes in the place of atlases: what they would become, and what suits them instead."""

from pathlib import Path

from bodymeasure._typing import Ints
from bodymeasure.errors import TriangleMeshError
from bodymeasure.wording import counted

# Extensions of files that hold triangle meshes and no atlas.
TRIANGLE_MESHES = (".stl", ".ply", ".off", ".glb", ".gltf")
# A mesh with more triangles than this part of its faces was not made of quads.
MOSTLY = 0.5
_KEEPS_ITS_UNIT = (".glb", ".gltf")


def require_quads(sizes: Ints, source: str, unit: str) -> None:
    """Refuse a mesh of triangles, which would become three times as many patches.

    Raises
    ------
    TriangleMeshError
        The message says what it would become, and what else can be done with it.
    """
    if not is_of_triangles(sizes):
        return
    triangles = int((sizes == 3).sum())
    raise TriangleMeshError(
        f"{source}: is a mesh of {counted(triangles, 'triangle')}, and would become "
        f"{sizes.sum():,} patches or more; {remedies(source, unit)}; to have the patches all the "
        "same, give --quads (quads=True in Python)"
    )


def no_atlas(path: Path) -> TriangleMeshError:
    """Return the error for a kind of file that holds triangles and no atlas."""
    unit = None if path.suffix.lower() in _KEEPS_ITS_UNIT else "UNIT"
    return TriangleMeshError(
        f"{path}: {path.suffix} files hold triangle meshes and no atlas; "
        f"{remedies(str(path), unit)}"
    )


def is_of_triangles(sizes: Ints) -> bool:
    """Return whether a mesh, given how many corners its faces have, was not made of quads."""
    return bool((sizes == 3).sum() > MOSTLY * len(sizes))


def remedies(source: str, unit: str | None = "UNIT") -> str:
    """Return what can be done with a triangle mesh in a file, instead of having patches of it."""
    given = f"{source} --file-unit {unit}" if unit else source
    return (
        f"if it is a body, fit an atlas to it: `bodymeasure fit {given}`, or at once "
        f"`bodymeasure chart {given}` (bm.fit_body in Python); if not, measure paths over the mesh "
        "itself: bm.measure_mesh(trimesh.load(...), start, end) in Python"
    )
