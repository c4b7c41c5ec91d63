"""Landmarks that lie farthest in a direction of the atlas's open boundary."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import EDGES, Atlas, AtlasPoint
from bodymeasure.atlas.seams import sides_of
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.bezier import bernstein, evaluate, project
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.landmarks.choice import (
    TIE,
    direction_vector,
    patches_of_regions,
    preferred,
)
from bodymeasure.chart.landmarks.rules.base import Direction, LandmarkRule, Landmarks, towards
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.section.roots import roots_of_polynomials

# Points on each side from which the nearest curve of the boundary is found.
SAMPLES = 8


class Boundary(LandmarkRule, frozen=True, kw_only=True, tag="boundary"):
    """The point of the atlas's open boundary that lies farthest in a direction.

    Parameters
    ----------
    direction : {"front", "back", "left", "right", "{side}", "up", "down"}
    regions : tuple of str
        The beginnings of the names of regions whose boundary is meant.
    near : str, optional
        A landmark: the closed curve of the boundary that passes closest to it is meant, whatever
        the regions.
    within : float
        The most that this curve may be away, as a multiple of its own length: a body that is not
        open there has other openings, such as those of the eyes.
    """

    example: ClassVar[str] = 'direction = "back"\nnear = "elbow point left"'

    direction: Direction
    regions: tuple[str, ...] = ()
    near: Landmark | None = None
    within: float = 3.0

    @property
    def description(self) -> str:
        of = ", ".join(self.regions) if self.near is None else f"the atlas nearest to {self.near}"
        return f"farthest {towards(self.direction)} of the boundary of {of}"

    def faults(self) -> Iterator[Fault]:
        if (self.near is None) != bool(self.regions):
            yield Fault(self, "", "give either regions or near")

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        direction = direction_vector(atlas, self.direction)
        if self.near is None:
            patch, side = _open_sides(atlas, patches_of_regions(atlas, self.regions))
        else:
            every = _open_sides(atlas, np.arange(len(atlas)))
            patch, side = _nearest_curve(atlas, every, self.near, landmarks, self.within)
        nets = sides_of(atlas.control_points)[patch, side]
        tie = TIE * extent(atlas)

        edge, along = _stations(nets, direction)
        fixed = np.array([e.fixed_value for e in EDGES])[side[edge]]
        over_v = (np.array([e.fixed_axis for e in EDGES]) == 0)[side[edge], None]
        parameters = np.where(
            over_v, np.stack([fixed, along], axis=-1), np.stack([along, fixed], axis=-1)
        )
        far = evaluate(atlas.control_points[patch[edge]], parameters) @ direction
        if ((project(nets) @ direction).min(axis=1) >= far.max() - tie).any():
            raise InputError(
                f"the boundary is level where it is farthest {self.direction}, so that many "
                "points are equally far; choose another rule, or pick the point"
            )
        best = np.flatnonzero(far >= far.max() - tie)
        return preferred(
            atlas, [AtlasPoint(int(patch[edge[k]]), *parameters[k].tolist()) for k in best]
        )


def _open_sides(atlas: Atlas, patches: Ints) -> tuple[Ints, Ints]:
    """Return patch and side (in the order of `EDGES`) of each open edge of some patches."""
    table = edges_of(atlas)
    control = table.control_index[patches]
    collapsed = (control == control[:, :, :1]).all(axis=2)
    row, side = np.nonzero((table.sides[table.edge[patches]] == 1) & ~collapsed)
    if not len(row):
        raise InputError("the atlas has no open boundary in these regions; choose others")
    return patches[row], side


def _nearest_curve(
    atlas: Atlas, sides: tuple[Ints, Ints], near: str, landmarks: Landmarks, within: float
) -> tuple[Ints, Ints]:
    """Return the sides that make up the boundary curve nearest to a landmark."""
    patch, side = sides
    ends = edges_of(atlas).control_index[patch, side][:, [0, -1]]
    curve = connected_components(ends[:, 0], ends[:, 1], len(atlas.points))[ends[:, 0]]
    along = np.arange(SAMPLES + 1) / SAMPLES
    nets = sides_of(atlas.control_points)[patch, side]
    values = bernstein(nets.shape[1] - 1, along)[:, 0]
    positions = project(np.einsum("tk,ekc->etc", values, nets))
    apart = np.linalg.norm(positions - atlas.position(landmarks[near]), axis=2).min(axis=1)
    nearest = curve == curve[np.argmin(apart)]
    length = np.linalg.norm(np.diff(positions[nearest], axis=1), axis=2).sum()
    if apart.min() > within * length:
        raise InputError(
            f"the boundary of the atlas that is nearest to {near!r} is {apart.min():.3g} "
            f"{atlas.unit} away, more than {within:.4g} times its own length: the body seems not "
            "to be open there; pick the point"
        )
    return patch[nearest], side[nearest]


def _stations(nets: Array, direction: Array) -> tuple[Ints, Array]:
    """Return curve and parameter of the ends and turning points of curves (k, m + 1, 3 or 4)."""
    roots = roots_of_polynomials(_slopes(nets, direction))
    along = np.concatenate([np.broadcast_to([0.0, 1.0], (len(nets), 2)), roots], axis=1)
    curve, number = np.nonzero(np.isfinite(along))
    return curve, along[curve, number]


def _slopes(nets: Array, direction: Array) -> Array:
    """Return Bernstein coefficients of a function with the sign of a coordinate's slope, by curve.

    For a rational curve f / w, the function is f' w - f w' of degree 2 m - 1, by interpolation.
    """
    coordinate = nets[..., :3] @ direction
    if nets.shape[-1] == 3:
        return np.diff(coordinate, axis=1)
    degree = nets.shape[1] - 1
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(2 * degree) + 0.5) / (2 * degree))
    value, slope = bernstein(degree, nodes, order=1).swapaxes(0, 1)
    weight = nets[..., 3]
    numerator = (coordinate @ slope.T) * (weight @ value.T)
    numerator -= (coordinate @ value.T) * (weight @ slope.T)
    return np.linalg.solve(bernstein(2 * degree - 1, nodes)[:, 0], numerator.T).T
