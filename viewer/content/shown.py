"""A body that is shown: its atlas, and what all drawings of it share."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint, edge_table
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign, outward_signs
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError

# Steps along a patch's side, and the most patches that are drawn so: with the smooth surface's own
# normals, 16 show no facets at any size. Meshes with many patches have small ones, and the page's
# memory is bounded.
SEGMENTS = {16: 1_000, 8: 4_000, 4: 16_000, 2: 64_000}
# Steps along a patch's side by which the outside is found.
STEPS = 4


@dataclass(frozen=True, eq=False)
class ShownBody:
    """A body that a page shows.

    Parameters
    ----------
    id : str
        The name by which requests refer to it.
    atlas : Atlas
    name : str
        What the page calls it.
    file : str
        The file that it was read from; empty if it came from elsewhere.
    version : int
        Grows when the file is read again.
    warnings : tuple of str
        Sentences about the file.
    settings : mapping of str to object, optional
        With what the file can be read again by `read_atlas`; None if it cannot.
    differences : ndarray, shape (patches, 2), optional
        Relative differences of the diagonals' lengths from the mesh, where a report has them.
    despite_errors : bool
        Whether charts are measured although the landmarks contradict the axes, sides or size.
    start : mapping of str to object
        With what the page begins, as members of its header.
    finest : int
        The most steps along a patch's side of the triangles that are drawn.
    """

    id: str
    atlas: Atlas
    name: str
    file: str = ""
    version: int = 1
    warnings: tuple[str, ...] = ()
    settings: Mapping[str, Any] | None = None
    differences: Array | None = None
    despite_errors: bool = False
    start: Mapping[str, object] = field(default_factory=dict)
    finest: int = max(SEGMENTS)

    @property
    def savable(self) -> bool:
        """Whether landmarks can be saved into the body's own file."""
        return self.settings is not None and self.file.lower().endswith(".atlas")

    @cached_property
    def mark(self) -> str:
        """A hash of all that a page holds of it, by which it sees that there is another one."""
        places = sorted((name, *place) for name, place in self.atlas.landmarks.items())
        return hashlib.sha256(repr((self.atlas.digest, self.name, places)).encode()).hexdigest()

    @property
    def place(self) -> str:
        """Under what a page keeps tapes: of a file, its path, whatever it holds later."""
        return self.atlas.digest if self.settings is None else self.file

    @property
    def segments(self) -> int:
        """Steps along a patch's side of the triangles that are drawn."""
        count = len(self.atlas)
        steps = next((steps for steps, most in SEGMENTS.items() if count <= most), 1)
        return min(steps, self.finest)

    @cached_property
    def rotation(self) -> Array:
        """The matrix (3, 3) from the atlas's axes to left, up and front."""
        axes = self.atlas.axes
        return np.stack([axes.left_vector, axes.up_vector, axes.front_vector])

    @property
    def meters(self) -> float:
        """The length of the atlas's unit in meters."""
        return self.atlas.unit.meters

    @cached_property
    def signs(self) -> Array:
        """By what S_u x S_v is multiplied to point out of the body, shape (patches,)."""
        atlas = self.atlas
        side = np.linspace(0.0, 1.0, STEPS + 1)
        grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
        samples = evaluate(atlas.control_points, np.broadcast_to(grid, (len(atlas), *grid.shape)))
        try:
            return outward_signs(atlas, samples, edge_table(atlas.index), "determined")
        except InputError:
            # A sheet has no outside; it is drawn from both sides all the same.
            return np.full(len(atlas), outward_sign(atlas))

    def positions_on_page(self, positions: Array) -> Array:
        """Return positions (..., 3) of the atlas in the page's axes, in meters."""
        return np.asarray(positions @ (self.meters * self.rotation).T)

    def vectors_on_page(self, vectors: Array) -> Array:
        """Return directions (..., 3) of the atlas in the page's axes."""
        return np.asarray(vectors @ self.rotation.T)

    def surface(self, patches: Ints, parameters: Array) -> tuple[Array, Array]:
        """Return points and normals on the page, (k, m, 3), at parameters (k, m, 2) of patches."""
        nets = self.atlas.control_points[patches]
        normals = self.signs[patches][:, None, None] * unit_normals(nets, parameters)
        return self.positions_on_page(evaluate(nets, parameters)), self.vectors_on_page(normals)

    def point(self, place: AtlasPoint) -> tuple[Array, Array]:
        """Return the point and the normal on the page at one place, each of shape (3,)."""
        where = np.array([[[place.u, place.v]]])
        points, normals = self.surface(np.array([place.patch]), where)
        return points[0, 0], normals[0, 0]
