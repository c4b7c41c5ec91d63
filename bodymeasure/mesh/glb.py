"""A body and paths over it as a GLB file, which any glTF viewer opens."""

from collections.abc import Mapping
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import file_path, shown
from bodymeasure.atlas import Atlas, tessellate
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.files import write_bytes
from bodymeasure.geodesic import AtlasPath
from bodymeasure.mesh.path import MeshPath
from bodymeasure.mesh.points import points_of
from bodymeasure.mesh.tubes import tube_surface

# Steps along a patch's side.
SEGMENTS = 8
# In meters: a tube as thick as a pencil is seen well on a body.
RADIUS = 0.003
# For other objects than bodies, as a part of their size.
THICKNESS = 0.002
# Sides of a tube: round enough at any size at which it is looked at.
SIDES = 12
SKIN = (217, 199, 184, 255)
# Okabe and Ito's colors, which the color-blind can distinguish.
COLORS = (
    (0, 114, 178, 255),
    (213, 94, 0, 255),
    (0, 158, 115, 255),
    (204, 121, 167, 255),
    (230, 159, 0, 255),
    (86, 180, 233, 255),
)


def write_glb(
    path: str | PathLike[str],
    atlas: Atlas,
    paths: Mapping[str, AtlasPath | MeshPath | ArrayLike] | None = None,
    *,
    segments: int = SEGMENTS,
) -> None:
    """Write a body, and paths over it as tubes, as binary glTF.

    Parameters
    ----------
    path : path-like
        Ends in ``.glb``.
    atlas : Atlas
    paths : mapping of str to AtlasPath, MeshPath or array_like of shape (k, 3), optional
        The paths by name; points are in the atlas's unit. Lengths go into the nodes' extras.
    segments : int
        Steps along a patch's side.

    Raises
    ------
    InputError
        If the extension is another, a path is not one, or the file cannot be written.
    MissingExtraError
        If trimesh is not installed.

    Notes
    -----
    glTF is in meters, with y upwards and bodies looking along z, so that the body is turned and
    scaled.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> with TemporaryDirectory() as folder:
    ...     bm.write_glb(Path(folder, "body.glb"), body, {"nape to bust": path})
    ...     [file.name for file in Path(folder).iterdir()]
    ['body.glb']
    """
    path = file_path(path)
    require_atlas(atlas)
    named: Mapping[str, AtlasPath | MeshPath | ArrayLike] = {} if paths is None else paths
    if not isinstance(named, Mapping):
        raise InputError(f"paths are {shown(paths)}; expected paths by their names, as in a dict")
    if path.suffix.lower() != ".glb":
        raise InputError(f"{path}: expected a name that ends in .glb")
    try:
        import trimesh
    except ImportError:
        raise MissingExtraError("a GLB file", "trimesh", "oracle") from None
    to_gltf = _to_gltf(atlas)
    scene: Any = trimesh.Scene()
    body: Any = tessellate(atlas, segments).to_trimesh()
    body.vertices = body.vertices @ to_gltf.T
    body.vertex_attributes.clear()
    body.visual.vertex_colors = SKIN
    body.metadata = {"unit": "m", "source": atlas.name}
    scene.add_geometry(body, geom_name=atlas.name or "body", node_name=atlas.name or "body")
    size = float(np.ptp(body.vertices, axis=0).max())
    radius = min(RADIUS, THICKNESS * size)
    for number, (name, given) in enumerate(named.items()):
        points, facts = points_of(repr(name), given, atlas.unit)
        if len(points) < 2 or not np.ptp(points, axis=0).any():
            continue
        vertices, _, faces = tube_surface(points @ to_gltf.T, radius, SIDES)
        drawn: Any = trimesh.Trimesh(vertices, faces, process=False, metadata=facts)
        drawn.visual.vertex_colors = COLORS[number % len(COLORS)]
        scene.add_geometry(drawn, geom_name=name, node_name=name)
    write_bytes(path, scene.export(file_type="glb"))


def _to_gltf(atlas: Atlas) -> Array:
    """Return the matrix (3, 3) from the atlas's coordinates to left, up and front in meters."""
    axes = atlas.axes
    rows = np.stack([axes.left_vector, axes.up_vector, axes.front_vector])
    return np.asarray(rows * atlas.unit.meters)
