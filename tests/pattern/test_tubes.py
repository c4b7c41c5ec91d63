"""Panels round a tube, slit along one curve that bounds them on both sides."""

from functools import cache

import msgspec
import numpy as np
import pytest
from helpers.panels import interpolated

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.pattern import Edge, Panel, load_pattern

RADIUS, HEIGHT = 0.06, 0.3
# Places on the tube, whose patches are quarters of it: it is slit on the first one.
PATCHES = {"": 0, "quarter ": 1, "far ": 2, "other ": 3}
HEIGHTS = {"low": 0.1, "middle": 0.5, "high": 0.8}


def quarter(number: int) -> Array:
    def surface(u: Array, v: Array) -> Array:
        angle = 0.5 * np.pi * (u + number)
        x, y = RADIUS * np.cos(angle), RADIUS * np.sin(angle)
        return np.stack([x, y, HEIGHT * v], axis=-1)

    # Rounded, so that neighbors have their sides in common.
    return np.asarray(np.round(interpolated(surface).control_points[0], 12))


@cache
def tube() -> bm.Atlas:
    nets = np.stack([quarter(number) for number in range(4)])
    points, index = np.unique(nets.reshape(-1, 3), axis=0, return_inverse=True)
    marks = {
        part + level: bm.AtlasPoint(patch, 0.3, height)
        for part, patch in PATCHES.items()
        for level, height in HEIGHTS.items()
    }
    return bm.Atlas(points, index.reshape(nets.shape[:-1]), bm.Unit.M, landmarks=marks)


def sleeve(*, turned: bool = False) -> bm.PatternDefinitions:
    def ring(name: str, start: str, end: str, via: str) -> Edge:
        return Edge(name=name, kind="section", through=(start, end), plane="level", via=via)

    # Both ways round are equally long, so that the way is said.
    edges: tuple[Edge, ...] = (
        Edge(name="up", kind="geodesic", through=("low", "high"), seam="slit"),
        ring("top 1", "high", "far high", "quarter high"),
        ring("top 2", "far high", "high", "other high"),
        Edge(name="down", kind="geodesic", through=("high", "low"), seam="slit"),
        ring("bottom 2", "low", "far low", "other low"),
        ring("bottom 1", "far low", "low", "quarter low"),
    )
    if turned:
        edges = tuple(
            msgspec.structs.replace(edge, through=edge.through[::-1]) for edge in edges[::-1]
        )
    panel = Panel(name="tube", inside="far middle", edge=edges, grain="up")
    return bm.PatternDefinitions(name="tube", panel=(panel,))


@pytest.mark.parametrize("turned", [False, True])
def test_a_slit_tube_is_a_rectangle(turned: bool) -> None:
    pattern = bm.make_pattern(tube(), sleeve(turned=turned))
    (piece,) = pattern.pieces
    assert piece.is_sound
    assert np.abs(piece.strains).max() < 1e-5
    size = np.ptp(piece.positions, axis=0)
    np.testing.assert_allclose(size, [2.0 * np.pi * RADIUS, 0.7 * HEIGHT], atol=1e-6)
    (seam,) = pattern.seams
    assert seam.edges in (("up", "down"), ("down", "up"))
    assert abs(seam.difference) < 1e-12
    # As seen from outside, what lies in the direction of the angle lies on the right.
    assert piece.edge("top 1").parts[0][:, 0].mean() < piece.edge("top 2").parts[0][:, 0].mean()


@pytest.mark.slow
def test_the_cap_of_a_sleeve_is_longer_than_the_armhole_by_its_ease() -> None:
    atlas = bm.load_sample("female_average")
    definitions = load_pattern("sleeve")
    only = msgspec.structs.replace(definitions, panel=definitions.panel[-1:])
    (piece,) = bm.make_pattern(atlas, only).pieces
    assert piece.is_sound
    assert piece.rms_strain < 0.065
    for cap in ("front cap", "back cap"):
        edge = piece.edge(cap)
        assert edge.length == pytest.approx(edge.skin_length + 0.008, abs=1e-12)
    assert piece.edge("front underarm").length == pytest.approx(
        piece.edge("back underarm").length, abs=1e-12
    )
