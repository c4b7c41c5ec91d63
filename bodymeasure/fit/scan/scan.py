"""Triangle meshes of bodies as they come from scanners and modelers, cleaned."""

from dataclasses import dataclass

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import Unit
from bodymeasure.atlas.axes import unit_vector


@dataclass(frozen=True, eq=False)
class Scan:
    """A triangle mesh in meters, with what is known of it.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        In meters, along the axes of the file.
    triangles : ndarray of int, shape (m, 3)
        Corners, counterclockwise as seen from outside the body.
    plate : ndarray of bool, shape (m,)
        Triangles that may belong to a floor or to the top of a stool: large and flat, with all of
        the mesh on one side. A fit does not look for the body there.
    file_unit : Unit
        Unit of the file's coordinates.
    up, front : str, optional
        Which way is up and which way the body looks, each one of ``+x -x +y -y +z -z``, as the user
        says; None where it is to be found.
    name : str
        What the scan is called: the name of its file without folder and extension.
    notes : tuple of str
        Sentences that say what was done to the mesh of the file.
    """

    vertices: Array
    triangles: Ints
    plate: Bools
    file_unit: Unit
    up: str | None = None
    front: str | None = None
    name: str = ""
    notes: tuple[str, ...] = ()

    @property
    def up_vector(self) -> Array | None:
        """Unit vector upwards, shape (3,), or None."""
        return None if self.up is None else unit_vector(self.up)

    @property
    def front_vector(self) -> Array | None:
        """Unit vector to the front, shape (3,), or None."""
        return None if self.front is None else unit_vector(self.front)
