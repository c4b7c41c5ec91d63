"""Fitted bodies as files for other programs."""

import json
from os import PathLike
from pathlib import Path
from typing import Protocol

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import file_path, require_members
from bodymeasure.errors import InputError
from bodymeasure.files import write_bytes
from bodymeasure.fit.export.body_mesh import BodyMesh, to_gltf
from bodymeasure.fit.export.glb import glb_content
from bodymeasure.fit.export.obj import obj_content
from bodymeasure.fit.model import bones_of, limit_matrix, skeleton, unposed
from bodymeasure.threads import one_blas_thread

KINDS = (".obj", ".glb", ".json")
FORMAT = "bodymeasure coefficients"


class _Fitted(Protocol):
    """What is written of a fitted body."""

    @property
    def vertices(self) -> Array: ...
    @property
    def coefficients(self) -> Array: ...
    @property
    def rotations(self) -> Array: ...
    @property
    def shift(self) -> Array: ...


@one_blas_thread()
def write_fitted(
    path: str | PathLike[str],
    fitted: _Fitted,
    *,
    a_pose: bool = False,
    control: bool = False,
    name: str = "",
) -> None:
    """Write a fitted body for other programs: its mesh (OBJ, GLB) or its coefficients (JSON).

    The mesh has the texture coordinates of MakeHuman's hm08, so that skins that are painted for
    it fit. OBJ has quads, in groups by the parts of the body; GLB has triangles and a skeleton
    with the bones' shares in each vertex, of which Blender makes an armature and vertex groups.
    Both are in meters, y up, the body looking along z.

    Parameters
    ----------
    path : path-like
        Ends in ``.obj``, ``.glb`` or ``.json``.
    fitted : FittedBody
    a_pose : bool
        Write the body in the A-pose: its pose is undone by the skeleton.
    control : bool
        Write the control vertices, for programs that subdivide the mesh. Without it the vertices
        lie on the surface, which is right for a mesh that is taken as it is.
    name : str
        What the body is called in the file.

    Raises
    ------
    InputError
        If the extension is another, `fitted` is no fitted body, or the file cannot be written.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> from bodymeasure.fit.model import body_model
    >>> body = bm.map_body((body_model().mean, body_model().quads), file_unit="m")
    >>> with TemporaryDirectory() as folder:
    ...     for file in ("body.obj", "body.glb", "body.json"):
    ...         bm.write_fitted(Path(folder, file), body, a_pose=True)
    ...     sorted(file.name for file in Path(folder).iterdir())
    ['body.glb', 'body.json', 'body.obj']
    """
    path = file_path(path)
    require_members(
        fitted,
        ("vertices", "coefficients", "rotations", "shift"),
        "fitted",
        "a FittedBody, as fit_body returns it",
    )
    kind = path.suffix.lower()
    if kind not in KINDS:
        raise InputError(f"{path}: expected a name that ends in one of {', '.join(KINDS)}")
    write_bytes(path, _content(fitted, kind, (a_pose, control), name or Path(path).stem))


def _content(fitted: _Fitted, kind: str, how: tuple[bool, bool], name: str) -> bytes:
    if kind == ".json":
        return _coefficients(fitted, name)
    mesh = body_mesh(fitted, a_pose=how[0], control=how[1], name=name)
    return obj_content(mesh) if kind == ".obj" else glb_content(mesh)


def body_mesh(fitted: _Fitted, *, a_pose: bool, control: bool, name: str) -> BodyMesh:
    """Return the mesh that is written."""
    coefficients, rotations, shift = fitted.coefficients, fitted.rotations, fitted.shift
    vertices = fitted.vertices
    if a_pose:
        vertices = unposed(vertices, coefficients, rotations, shift)
        joints = skeleton().joints_of(coefficients)
    else:
        joints = bones_of(coefficients, rotations, shift).places
    surface = limit_matrix() @ vertices
    if a_pose:
        floor = np.array([0.0, 0.0, surface[:, 2].min()])
        vertices, surface, joints = vertices - floor, surface - floor, joints - floor
    described = (
        "The vertices are control vertices: subdivide the mesh (Catmull-Clark) for its surface."
        if control
        else "The vertices lie on the surface."
    )
    pose = "The A-pose." if a_pose else "The pose of the scan."
    return BodyMesh(
        to_gltf(vertices if control else surface), to_gltf(joints), name, f"{pose} {described}"
    )


def _coefficients(fitted: _Fitted, name: str) -> bytes:
    rotations = zip(skeleton().names, fitted.rotations.tolist(), strict=True)
    content = {
        "format": FORMAT,
        "version": 1,
        "name": name,
        "described": "Coefficients in standard deviations of the body space; rotation vectors of "
        "the joints in radians, each in the frame of the joint that carries it; shift of the "
        "pelvis in meters; z up, front = -y.",
        "coefficients": fitted.coefficients.tolist(),
        "rotations": dict(rotations),
        "shift": fitted.shift.tolist(),
    }
    return (json.dumps(content, indent=1) + "\n").encode()
