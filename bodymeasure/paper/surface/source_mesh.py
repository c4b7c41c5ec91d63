"""The quad meshes that the sample mannequins were fitted to."""

import numpy as np

from bodymeasure.errors import InputError
from bodymeasure.samples import sample_path
from bodymeasure.subdivision import QuadMesh

# Beside the samples; written by `sample_patches/quad_meshes.py`.
FILE = "quad_meshes.npz"
PER_METRE = 1_000_000


def load_source_mesh(name: str) -> tuple[QuadMesh, int]:
    """The quad mesh to whose Catmull-Clark limit surface a sample's atlas was fitted.

    Parameters
    ----------
    name : str
        A sample's name.

    Returns
    -------
    mesh : QuadMesh
        In metres, as the samples are. Some rings of quads wider than the atlas.
    covered : int
        So many quads, the first, are those that the atlas covers.

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
        vertices = data[name] / PER_METRE
        return QuadMesh(vertices, data["quads"].astype(np.int64)), int(data["covered"])
