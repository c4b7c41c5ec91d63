"""Pieces against closed forms, and what must not change them."""

from collections.abc import Callable
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from helpers.panels import (
    CORNERS,
    cone,
    cylinder,
    developed_cone,
    developed_cylinder,
    four_geodesics,
    interpolated,
)
from scipy.spatial.transform import Rotation

from bodymeasure import (
    Atlas,
    AtlasPoint,
    Axes,
    PatternDefinitions,
    Piece,
    Unit,
    load_sample,
    make_pattern,
)
from bodymeasure._typing import Array
from bodymeasure.pattern import Dart, Edge, Panel, load_pattern


def corners_of(piece: Piece) -> Array:
    """The starts of the edges, in the order of the panel."""
    order = {edge.name: edge for edge in piece.edges}
    starts = []
    for edge in piece.panel.edge:
        parts = order[edge.name].parts
        starts.append(np.stack([parts[0][0], parts[-1][-1]]))
    shared = []
    for before, here in zip([starts[-1], *starts[:-1]], starts, strict=True):
        gaps = np.linalg.norm(before[:, None] - here, axis=2)
        shared.append(here[int(gaps.min(axis=0).argmin())])
    return np.array(shared)


def distances(points: Array) -> Array:
    return np.asarray(np.linalg.norm(points[:, None] - points, axis=2))


@pytest.mark.parametrize(
    ("surface", "developed"), [(cylinder, developed_cylinder), (cone, developed_cone)]
)
@pytest.mark.parametrize("fold", ["", "ab"])
def test_what_can_be_developed_flattens_without_strain(
    surface: Callable[[Array, Array], Array],
    developed: Callable[[Array, Array], Array],
    fold: str,
) -> None:
    piece = make_pattern(interpolated(surface), four_geodesics(fold=fold)).pieces[0]
    assert np.abs(piece.strains).max() < 1e-5
    flat = developed(*np.array(CORNERS).T)
    np.testing.assert_allclose(distances(corners_of(piece)), distances(flat), atol=2e-8)
    # Geodesics are straight in the plane.
    for edge in piece.edges:
        (points,) = edge.parts
        way = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
        aside = (points - points[0]) @ np.array([-way[1], way[0]])
        assert np.abs(aside).max() < 1e-6
    if fold:
        np.testing.assert_allclose(piece.edge("ab").parts[0][:, 0], 0.0, atol=1e-14)


def cap_strain(angle: float, count: int = 800) -> float:
    """The least root mean square strain of a cap of the unit sphere whose rim keeps its length.

    By rotational symmetry it is a least squares problem for the flat radius of each parallel.
    """
    s = np.linspace(0.0, angle, count + 1)
    middle, step = 0.5 * (s[1:] + s[:-1]), angle / count
    weight = np.sqrt(np.sin(middle) * step)
    along, around = np.zeros((2, count, count + 1))
    rows = np.arange(count)
    along[rows, rows], along[rows, rows + 1] = -1.0 / step, 1.0 / step
    around[rows, rows] = around[rows, rows + 1] = 0.5 / np.sin(middle)
    matrix = np.concatenate([weight[:, None] * along, weight[:, None] * around])
    right = np.concatenate([weight, weight]) - matrix[:, -1] * np.sin(angle)
    # The middle stays, and so does the rim.
    inner = matrix[:, 1:-1]
    radius = np.linalg.solve(inner.T @ inner, inner.T @ right)
    square = ((inner @ radius - right) ** 2).sum()
    return float(np.sqrt(0.5 * square / (weight**2).sum()))


def test_the_strain_of_small_caps_has_a_closed_form() -> None:
    assert cap_strain(0.05) == pytest.approx(np.sqrt(42.0) / 48.0 * 0.05**2, rel=2e-3)


@pytest.mark.parametrize("angle", [0.3, pytest.param(0.4, marks=pytest.mark.slow)])
def test_the_strain_of_a_spherical_cap_is_that_of_theory(angle: float) -> None:
    radius = 0.4

    def sphere(u: Array, v: Array) -> Array:
        x, y = 2.5 * angle * (u - 0.5), 2.5 * angle * (v - 0.5)
        points = np.stack([x, y, np.ones_like(x)], axis=-1)
        return np.asarray(radius * points / np.linalg.norm(points, axis=-1, keepdims=True))

    atlas = interpolated(sphere)
    rim = np.tan(angle) / (2.5 * angle)
    turns = 2.0 * np.pi * np.arange(3) / 3.0 + 0.1
    landmarks = {
        name: AtlasPoint(0, 0.5 + rim * np.cos(turn), 0.5 + rim * np.sin(turn))
        for name, turn in zip("abc", turns, strict=True)
    }
    atlas = replace(atlas, landmarks={**landmarks, "m": AtlasPoint(0, 0.5, 0.5)})
    edges = tuple(
        Edge(name=start + end, kind="section", through=(start, end), plane=("a", "b", "c"))
        for start, end in ("ab", "bc", "ca")
    )
    panel = Panel(name="cap", inside="m", edge=edges)
    piece = make_pattern(atlas, PatternDefinitions(name="cap", panel=(panel,)), step=0.004).pieces[
        0
    ]
    rim_length = sum(edge.length for edge in piece.edges)
    assert rim_length == pytest.approx(2.0 * np.pi * radius * np.sin(angle), rel=1e-7)
    assert piece.rms_strain == pytest.approx(cap_strain(angle), rel=0.015)


def test_seams_are_exact_and_a_dart_takes_the_strain_out_of_a_dome() -> None:
    atlas = interpolated(
        lambda u, v: np.stack([0.3 * u, 0.3 * v, 0.3 * u * (1 - u) * 4 * v * (1 - v)], axis=-1)
    )
    bare = make_pattern(atlas, four_geodesics(fold="da")).pieces[0]
    dart = Dart(name="dart", edge="bc", at=0.5, tip="m", short=0.02)
    shaped = Dart(name="dart", edge="bc", at=0.5, tip="m", short=0.02, legs="shaped")
    pieces = [
        make_pattern(atlas, four_geodesics(fold="da", dart=(d,))).pieces[0] for d in (dart, shaped)
    ]
    for piece in (bare, *pieces):
        assert piece.flips == 0
        assert piece.is_simple
        assert piece.warnings == ()
        for edge in piece.edges:
            assert edge.length == pytest.approx(edge.skin_length, abs=1e-12)
    assert pieces[1].rms_strain < pieces[0].rms_strain < bare.rms_strain
    for piece in pieces:
        (cut,) = piece.darts
        assert cut.angle > 0.0
        for leg in cut.legs:
            length = np.linalg.norm(np.diff(leg, axis=0), axis=1).sum()
            assert length == pytest.approx(cut.length, abs=1e-12)
    for leg in pieces[0].darts[0].legs:
        assert np.linalg.norm(leg[-1] - leg[0]) == pytest.approx(
            pieces[0].darts[0].length, abs=1e-12
        )


def test_a_dart_in_a_saddle_is_left_out_and_said() -> None:
    atlas = interpolated(
        lambda u, v: np.stack([0.3 * u, 0.3 * v, 0.5 * (u - 0.5) * (v - 0.5)], axis=-1)
    )
    dart = Dart(name="dart", edge="ab", at=0.5, tip="m")
    piece = make_pattern(atlas, four_geodesics(dart=(dart,))).pieces[0]
    assert piece.darts == ()
    assert "left out: its legs would overlap by" in piece.warnings[0]


def on_the_right(definitions: PatternDefinitions) -> PatternDefinitions:
    text = msgspec.json.encode(definitions).decode()
    text = text.replace("left", "?").replace("right", "left").replace("?", "right")
    return msgspec.json.decode(text, type=PatternDefinitions)


@pytest.fixture(scope="module")
def skirt() -> Piece:
    return make_pattern(load_sample("female_average"), "skirt").pieces[1]


def back_of(
    body: Atlas, definitions: PatternDefinitions | None = None, step: float = 0.008
) -> Piece:
    definitions = definitions or load_pattern("skirt")
    only = msgspec.structs.replace(definitions, panel=definitions.panel[1:])
    return make_pattern(body, only, step=step).pieces[0]


@pytest.fixture(scope="module")
def leaning() -> Atlas:
    """A body that leans to one side.

    On a symmetric one the center back line may run a hair left or right of its seam: both are
    equally long, and rounding chooses one of them.
    """
    body = load_sample("female_average")
    return replace(body, points=body.points + 0.05 * body.points[..., 2:] * [1.0, 0.0, 0.0])


@pytest.fixture(scope="module")
def leaning_skirt(leaning: Atlas) -> Piece:
    return back_of(leaning)


@pytest.mark.slow
def test_the_unit_and_a_move_change_nothing(leaning: Atlas, leaning_skirt: Piece) -> None:
    points = 100.0 * (leaning.points + np.array([0.7, -0.3, 0.0]))
    moved = back_of(replace(leaning, points=points, unit=Unit.CM))
    assert moved.rms_strain == pytest.approx(leaning_skirt.rms_strain, rel=1e-4)
    np.testing.assert_allclose(corners_of(moved) / 100.0, corners_of(leaning_skirt), atol=2e-6)


@pytest.mark.slow
def test_a_general_rotation_changes_nothing() -> None:
    body = interpolated(cone)
    rotation = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
    turned = replace(body, points=body.points @ rotation.T + np.array([3.0, -2.0, 0.5]))
    panels = four_geodesics(fold="ab")
    here, there = (make_pattern(each, panels).pieces[0] for each in (body, turned))
    np.testing.assert_allclose(corners_of(there), corners_of(here), atol=1e-8)


@pytest.mark.slow
def test_a_body_that_lies_gives_the_same_pieces(leaning: Atlas, leaning_skirt: Piece) -> None:
    # Up becomes the second axis, and the front the third.
    quarter = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    points = leaning.points @ quarter.T + np.array([0.1, 2.0, -1.0])
    lying = back_of(replace(leaning, points=points, axes=Axes(up="+y", front="+z")))
    assert lying.rms_strain == pytest.approx(leaning_skirt.rms_strain, rel=1e-4)
    for edge in leaning_skirt.edges:
        assert lying.edge(edge.name).length == pytest.approx(edge.length, abs=1e-6)
    np.testing.assert_allclose(corners_of(lying), corners_of(leaning_skirt), atol=2e-6)


def test_the_other_side_is_the_mirror_image(skirt: Piece) -> None:
    mirrored = back_of(load_sample("female_average"), on_the_right(load_pattern("skirt")))
    assert mirrored.rms_strain == pytest.approx(skirt.rms_strain, rel=5e-3)
    for one in skirt.edges:
        # The body is symmetric to a micrometer.
        assert mirrored.edge(one.name).length == pytest.approx(one.length, abs=2e-6)
    np.testing.assert_allclose(corners_of(mirrored) * [-1.0, 1.0], corners_of(skirt), atol=2e-4)


@pytest.mark.slow
def test_a_finer_mesh_changes_no_seam_and_hardly_the_strain(skirt: Piece) -> None:
    fine = back_of(load_sample("female_average"), step=0.004)
    for edge in fine.edges:
        # The hem lies on no skin.
        if edge.name != "hip":
            assert edge.length == pytest.approx(skirt.edge(edge.name).length, abs=1e-12)
    assert fine.rms_strain == pytest.approx(skirt.rms_strain, abs=1e-3)


def test_an_outline_that_crosses_itself_is_said_and_no_sound_piece() -> None:
    # An edge three times as long as its curve: more than a piece of that size can take up.
    definitions = four_geodesics()
    (panel,) = definitions.panel
    long = msgspec.structs.replace(panel.edge[0], seam="side", ease=0.3)
    panel = msgspec.structs.replace(panel, edge=(long, *panel.edge[1:]))
    made = make_pattern(interpolated(cylinder), PatternDefinitions(name="p", panel=(panel,)))
    assert not made.pieces[0].is_simple
    assert not made.is_sound
    words = (
        "panel: the outline crosses itself; ease less into its seams, cut the panel into two, or"
    )
    assert any(warning.startswith(words) for warning in made.warnings)
