"""Wavefront OBJ, ``.obj``: free-form surfaces or a mesh, whichever a file holds."""

from bodymeasure.errors import InputError
from bodymeasure.formats.obj import mesh as obj_mesh
from bodymeasure.formats.obj import surfaces as obj_surfaces
from bodymeasure.formats.obj.mesh import Faces
from bodymeasure.formats.obj.statements import parse
from bodymeasure.formats.patches import ReadPatches


def read(content: bytes, source: str) -> ReadPatches | Faces:
    """Return the surfaces or the mesh that a file holds.

    Raises
    ------
    InputError
        If it holds neither or both.
    """
    file = parse(content, source)
    has_surfaces, has_faces = "surf" in file.keywords, bool(file.keywords & {"f", "fo"})
    if has_surfaces and has_faces:
        raise InputError(
            f"{source}: holds free-form surfaces and faces; say which to take with the format "
            "obj-surfaces or obj-mesh"
        )
    if has_faces:
        return obj_mesh.from_statements(file, source)
    if has_surfaces:
        return obj_surfaces.from_statements(file, source)
    raise InputError(f"{source}: holds neither surfaces (surf) nor faces (f); expected either")
