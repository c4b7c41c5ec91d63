"""Smooth curves through landmarks, put on the skin."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.pattern import Edge, Panel
from bodymeasure.pattern.curves.smooth import smooth_curve
from bodymeasure.pattern.definitions.checks import panel_faults

RADIUS = 0.3


def cap() -> bm.Atlas:
    """A part of a sphere."""

    def sphere(u: Array, v: Array) -> Array:
        points = np.stack([u - 0.5, v - 0.5, np.ones_like(u)], axis=-1)
        return np.asarray(RADIUS * points / np.linalg.norm(points, axis=-1, keepdims=True))

    return interpolated(sphere)


def test_a_curve_through_points_of_a_circle_is_nearly_that_circle() -> None:
    atlas = cap()
    angles = np.linspace(0.0, 0.5 * np.pi, 7)
    # A circle of latitude, which is no geodesic.
    points = [bm.AtlasPoint(0, *(0.5 + 0.4 * np.array([np.cos(a), np.sin(a)]))) for a in angles]
    curve = smooth_curve(atlas, points)
    radius = RADIUS * 0.4 / np.hypot(1.0, 0.4)
    assert curve.length == pytest.approx(0.5 * np.pi * radius, rel=1e-3)
    patch, parameters = curve.places(np.linspace(0.0, curve.length, 50))
    places = evaluate(atlas.control_points[patch], parameters)
    away = np.hypot(places[:, 0], places[:, 1]) - radius
    assert np.abs(away).max() < 5e-4
    for point in points:
        gaps = np.linalg.norm(places - atlas.position(point), axis=1)
        assert gaps.min() < 0.5 * curve.length / 49 + 1e-4


def test_a_panel_with_a_curve_keeps_its_length() -> None:
    body = interpolated(cylinder)
    body = replace(body, landmarks={**body.landmarks, "n": bm.AtlasPoint(0, 0.5, 0.02)})
    definitions = four_geodesics()
    (panel,) = definitions.panel
    curved = Edge(name="ab", kind="curve", through=("a", "n", "b"))
    panel = replace_edge(panel, curved)
    piece = bm.make_pattern(body, bm.PatternDefinitions(name="p", panel=(panel,))).pieces[0]
    straight = bm.make_pattern(body, definitions).pieces[0]
    assert piece.is_sound
    # Chords of 8 mm are a little shorter than the curve.
    assert piece.rms_strain < 5e-4
    assert piece.edge("ab").length > straight.edge("ab").length
    assert piece.edge("ab").length == pytest.approx(piece.edge("ab").skin_length, abs=1e-12)


def replace_edge(panel: Panel, edge: Edge) -> Panel:
    return msgspec.structs.replace(panel, edge=(edge, *panel.edge[1:]))


def test_a_curve_has_no_plane() -> None:
    (panel,) = four_geodesics().panel
    edge = Edge(name="ab", kind="curve", through=("a", "b"), plane="front")
    (fault,) = panel_faults(replace_edge(panel, edge))
    assert "is a curve, which has neither plane nor via" in fault
