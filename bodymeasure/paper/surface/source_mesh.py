"""The quad meshes to which the sample mannequins were fitted."""

import numpy as np

from bodymeasure.errors import InputError
from bodymeasure.samples import sample_path
from bodymeasure.subdivision import QuadMesh

# The file beside the samples, which `sample_patches/quad_meshes.py` writes.
FILE = "quad_meshes.npz"
PER_METER = 1_000_000


def load_source_mesh(name: str) -> tuple[QuadMesh, int]:
    """Return the quad mesh to whose Catmull-Clark limit surface a sample's atlas was fitted.

    Parameters
    ----------
    name : str
        A sample's name.

    Returns
    -------
    mesh : QuadMesh
        The mesh in meters, as the samples are, some rings of quads wider than the atlas.
    covered : int
        The number of quads, from the first on, that the atlas covers.

    Raises
    ------
    InputError
        If there is no such sample, or it was not fitted to a mesh.
    """
    path = sample_path(name).with_name(FILE)
    with np.load(path) as data:
        bodies = sorted(set(data.files) - {"quads", "covered"})
        if name not in bodies:
            raise InputError(
                f"sample {name!r} was not fitted to a mesh, so there is nothing to compare it "
                f"with; choose one of {', '.join(bodies)}"
            )
        vertices = data[name] / PER_METER
        return QuadMesh(vertices, data["quads"].astype(np.int64)), int(data["covered"])
