"""A body that is being measured: its landmarks, and the girths that several measurements share."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.errors import InputError
from bodymeasure.measure import Girth, body_girth, plane_girth
from bodymeasure.section import DrawnTape, Plane
from bodymeasure.wording import hint


class MissingLandmarkError(InputError):
    """A measurement needs a landmark that the body does not have."""


class Trust(NamedTuple):
    """What is known of the landmarks' places.

    Parameters
    ----------
    uncertainty : mapping of str to float
        The root mean square distance of each landmark from its place along the skin, in the atlas's
        unit. Landmarks that are not here are taken as they are.
    unseen : mapping of str to str
        The landmarks whose places the scan does not show, each with the landmark on a patch without
        scan that it is, or follows from.
    """

    uncertainty: Mapping[str, float]
    unseen: Mapping[str, str]


@dataclass(frozen=True, eq=False)
class Body:
    """An atlas with its landmarks, as far as rules can complete them.

    Parameters
    ----------
    atlas : Atlas
    landmarks : mapping of str to AtlasPoint
        The atlas's own landmarks, and those that rules gave.
    missing : mapping of str to str
        The landmarks that rules could not give, each with the reason.
    trust : Trust
        How far the landmarks of a body that was fitted to a scan may be from their places.
    """

    atlas: Atlas
    landmarks: Mapping[str, AtlasPoint]
    missing: Mapping[str, str] = field(default_factory=dict)
    trust: Trust = Trust({}, {})  # noqa: RUF009  (nothing writes to it)
    _girths: dict[tuple[str, bytes, bool], Girth] = field(default_factory=dict, repr=False)

    @cached_property
    def _outwards(self) -> float:
        return outward_sign(self.atlas)

    def point(self, name: str) -> AtlasPoint:
        """Return the landmark of a name.

        Raises
        ------
        MissingLandmarkError
        """
        if name in self.landmarks:
            return self.landmarks[name]
        if name in self.missing:
            raise MissingLandmarkError(
                f"the landmark {name!r} is missing: {self.missing[name]}; "
                "add it with `bodymeasure landmarks`"
            )
        known = sorted(self.landmarks)
        near = f"; {hint(name, known)}" if known else "; it has none at all"
        raise MissingLandmarkError(f"the atlas has no landmark {name!r}{near}")

    def position(self, name: str) -> Array:
        """Return the position of a landmark, shape (3,), in the atlas's unit."""
        return self.atlas.position(self.point(name))

    def girth(self, plane: Plane, at: str, *, limb: bool = False) -> Girth:
        """Return the girth in a plane through a landmark; each girth is found once."""
        key = (at, plane.normal.tobytes(), limb)
        if key not in self._girths:
            self._girths[key] = plane_girth(self.atlas, plane, self.point(at), limb=limb)
        return self._girths[key]

    def level_girth(
        self, at: str, *, cut: tuple[str, str] | None = None, limb: bool = False
    ) -> Girth:
        """Return the horizontal girth at a landmark's height.

        Parameters
        ----------
        at : str
        cut : tuple of (str, str), optional
            The armpits at which arms that the loop merges with the trunk are cut off.
        limb : bool
            Whether the loop has to go round one leg or arm alone.
        """
        if cut is None:
            return self.girth(Plane(self.position(at), self.atlas.axes.up_vector), at, limb=limb)
        left, right = (self.point(name) for name in cut)
        return body_girth(self.atlas, self.point(at), cut=(left, right))

    def tape(self, kind: TapeKind, drawn: DrawnTape) -> Tape:
        """Return a tape along a section, to be drawn."""
        on_skin = drawn.patch >= 0
        normals = np.zeros_like(drawn.positions)
        normals[on_skin] = self.normals(drawn.patch[on_skin], drawn.parameters[on_skin])
        return Tape(kind, drawn.positions, normals)

    def normals(self, patch: Ints, parameters: Array) -> Array:
        """Return unit vectors out of the body at some of its points; 0 where a patch has no normal.

        Parameters
        ----------
        patch : ndarray of int, shape (k,)
        parameters : ndarray, shape (k, 2)

        Returns
        -------
        ndarray, shape (k, 3)
        """
        nets = self.atlas.control_points[patch]
        return np.asarray(self._outwards * unit_normals(nets, parameters[:, None])[:, 0])
