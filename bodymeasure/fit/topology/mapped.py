"""Bodies of known topologies as bodies of ours, without a search."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.fit.model import limit_matrix
from bodymeasure.fit.topology.correspondence import Topology, mapped_vertices
from bodymeasure.fit.topology.known import require
from bodymeasure.fit.topology.placing import placed
from bodymeasure.fit.topology.polygons import Polygons

# A trunk that leans by more degrees may be one whose file says another axis.
LEAN = 25.0


class MappedBody(NamedTuple):
    """A body by correspondence.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        Control vertices in meters, z up, the pelvis facing -y, the lowest point at z = 0.
    transform : ndarray, shape (4, 4)
        From the file's coordinates, in its unit, to these.
    notes, warnings : tuple of str
        Sentences.
    """

    vertices: Array
    transform: Array
    notes: tuple[str, ...]
    warnings: tuple[str, ...]


def mapped_body(
    mesh: Polygons,
    topology: Topology,
    unit: Unit,
    *,
    up: str | None = None,
    source: str = "the mesh",
) -> MappedBody:
    """Return a body of a topology as one of ours.

    Parameters
    ----------
    mesh : Polygons
    topology : Topology
    unit : Unit
        Unit of the mesh.
    up : str, optional
        The axis of the mesh that is up, if it is not to be found.
    source : str
        Names the mesh in errors.

    Raises
    ------
    InputError
        If the mesh is not of the topology.
    FitError
        If the body has not the size of one, is mirrored, or does not stand along `up`.
    """
    require(mesh, topology, source)
    vertices = mapped_vertices(mesh.vertices * unit.meters, topology)
    surface = limit_matrix() @ vertices
    place = placed(vertices, surface, up, source)
    transform = np.eye(4)
    transform[:3, :3], transform[:3, 3] = unit.meters * place.turn, place.shift
    notes = [topology.source]
    if up is None:
        notes.append(f"Up is {place.up} of the file, as the trunk shows.")
    warnings = []
    if place.lean > LEAN:
        warnings.append(
            f"The trunk leans by {place.lean:.0f} degrees from {place.up}, which is taken to be "
            "up; heights and horizontal girths are those of that posture."
        )
    return MappedBody(
        vertices @ place.turn.T + place.shift, transform, tuple(notes), tuple(warnings)
    )
