"""Surfaces with landmarks, and panels on them, whose flat pieces are known."""

from collections.abc import Callable

import numpy as np

from bodymeasure import Atlas, AtlasPoint, PatternDefinitions
from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein
from bodymeasure.pattern import Edge, Panel

# Corners of a panel in the parameters of a surface: none of its sides is straight there.
CORNERS = ((0.15, 0.2), (0.85, 0.1), (0.75, 0.9), (0.2, 0.7))
MIDDLE = (0.5, 0.5)


def interpolated(surface: Callable[[Array, Array], Array]) -> Atlas:
    """A patch of degree 9 through the points of a surface over [0, 1]^2, in meters."""
    nodes = 0.5 - 0.5 * np.cos(np.pi * np.arange(10) / 9)
    inverse = np.linalg.inv(bernstein(9, nodes)[:, 0])
    points = surface(*np.meshgrid(nodes, nodes, indexing="ij"))
    net = np.einsum("ai,bj,ijc->abc", inverse, inverse, points)
    atlas = Atlas.from_control_points(net, unit="m")
    landmarks = {
        name: AtlasPoint(0, *at) for name, at in zip("abcdm", (*CORNERS, MIDDLE), strict=True)
    }
    return Atlas(atlas.points, atlas.index, atlas.unit, landmarks=landmarks)


def cylinder(u: Array, v: Array) -> Array:
    """A cylinder with a radius of 10 cm, about the third axis."""
    angle = 2.0 * u
    return np.stack([0.1 * np.cos(angle), 0.1 * np.sin(angle), 0.2 * v], axis=-1)


def developed_cylinder(u: Array, v: Array) -> Array:
    return np.stack([0.2 * u, 0.2 * v], axis=-1)


def cone(u: Array, v: Array) -> Array:
    """A cone whose generators make an angle of 30 degrees with its axis."""
    angle, along = 2.0 * u, 0.15 + 0.2 * v
    radius = along * 0.5
    return np.stack(
        [radius * np.cos(angle), radius * np.sin(angle), along * np.sqrt(0.75)], axis=-1
    )


def developed_cone(u: Array, v: Array) -> Array:
    angle, along = 2.0 * u * 0.5, 0.15 + 0.2 * v
    return np.stack([along * np.cos(angle), along * np.sin(angle)], axis=-1)


def four_geodesics(**members: object) -> PatternDefinitions:
    """The panel between the corners."""
    edges = tuple(
        Edge(name=f"{start}{end}", kind="geodesic", through=(start, end))
        for start, end in ("ab", "bc", "cd", "da")
    )
    panel = Panel(name="panel", inside="m", edge=edges, **members)  # type: ignore[arg-type]
    return PatternDefinitions(name="panel", panel=(panel,))
