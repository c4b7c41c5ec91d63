"""Garments that are wider than the body."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import msgspec
import numpy as np
import pytest
from helpers.panels import CORNERS, cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.pattern import load_pattern
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.cloth.ease import ease_of, landmarks_of
from bodymeasure.pattern.definitions.landmarks import panel_landmarks
from bodymeasure.pattern.flat.level_line import level_line
from bodymeasure.pattern.pieces.edges import EdgeCurves
from bodymeasure.section import convex_hull, plane_section

EASE = {"bust": 0.04, "waist": 0.02}


def test_a_cylinder_with_ease_is_a_wider_one() -> None:
    piece = bm.make_pattern(interpolated(cylinder), four_geodesics(), ease={"m": 0.04}).pieces[0]
    # The whole girth grows by 4 cm: a panel over an angle of 2 du by its part of that.
    u, v = np.array(CORNERS).T
    wide = np.stack([(0.2 + 2.0 * 0.04 / (2.0 * np.pi)) * u, 0.2 * v], axis=1)
    assert np.abs(piece.strains).max() < 1e-5
    for edge, start in zip(("ab", "bc", "cd", "da"), range(4), strict=True):
        (points,) = piece.edge(edge).parts
        chord = np.linalg.norm(points[-1] - points[0])
        assert chord == pytest.approx(np.linalg.norm(wide[(start + 1) % 4] - wide[start]), abs=2e-8)
        assert piece.edge(edge).cloth_length > piece.edge(edge).skin_length


def test_a_whole_turn_grows_by_the_ease() -> None:
    def tube(u: Array, v: Array) -> Array:
        return np.asarray(cylinder(3.0 * u, v))

    body = interpolated(tube)
    corners = ((0.02, 0.1), (0.98, 0.1), (0.98, 0.9), (0.02, 0.9))
    marks = {name: bm.AtlasPoint(0, *at) for name, at in zip("abcd", corners, strict=True)}
    body = replace(body, landmarks={**body.landmarks, **marks})
    piece, wider = (
        bm.make_pattern(body, four_geodesics(), ease=ease).pieces[0] for ease in (None, {"m": 0.04})
    )
    turn = 6.0 * 0.96 / (2.0 * np.pi)
    assert wider.edge("ab").length - piece.edge("ab").length == pytest.approx(0.04 * turn, abs=1e-5)


def loop_length(cloth: Cloth, at: bm.AtlasPoint) -> float:
    """The length of a level curve round the trunk, as the cloth lies above it."""
    body = cloth.atlas
    position = body.position(at)
    loop = plane_section(body, bm.Plane(position, body.axes.up_vector)).nearest(position)
    parts = np.linspace(0.0, 1.0, 33)[:-1]
    every = np.arange(loop.count)
    parameters = loop.surface.parameters(loop.pieces, np.tile(parts, (len(every), 1)))
    patch = np.repeat(loop.pieces.patch, len(parts))
    points = cloth.positions(patch, parameters.reshape(-1, 2))
    return float(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum())


@pytest.mark.parametrize("name", ["female_full_bust", "male_average"])
def test_girths_grow_by_the_ease_that_is_asked_for(name: str) -> None:
    body = bm.load_sample(name)
    skin, cloth = Cloth(body), Cloth(body, ease_of(body, EASE, body.landmarks))
    for landmark, ease in (("bust point left", 0.04), ("front waist point", 0.02)):
        at = body.landmarks[landmark]
        assert loop_length(cloth, at) - loop_length(skin, at) == pytest.approx(ease, abs=5e-4)


def test_cloth_has_no_gaps_where_patches_meet_at_an_angle() -> None:
    # The breasts of this body, and its center front, have such seams: with a gap at each, the girth
    # of the bust would grow by 1.3 mm more than it is to.
    body = bm.load_sample("female_old")
    skin, cloth = Cloth(body), Cloth(body, ease_of(body, EASE, body.landmarks))
    at = body.landmarks["bust point left"]
    assert loop_length(cloth, at) - loop_length(skin, at) == pytest.approx(0.04, abs=9e-4)


@pytest.mark.slow
def test_ease_is_the_same_in_other_units() -> None:
    # In one of them, rounding makes the curve of the waist end beyond the seam at the center front.
    body = bm.load_sample("female_average")
    scaled = replace(body, points=100.0 * body.points, unit=bm.Unit("cm"))
    definitions = load_pattern("bodice")
    definitions = msgspec.structs.replace(definitions, panel=definitions.panel[:1])
    lengths = [
        1000.0
        * one.unit.meters
        * bm.make_pattern(one, definitions, ease=EASE).pieces[0].edge("waist").cloth_length
        for one in (body, scaled)
    ]
    assert lengths[0] == pytest.approx(lengths[1], abs=1e-6)


def test_edges_in_a_row_are_as_long_with_ease_as_the_one_that_they_are_sewn_to() -> None:
    # The shoulder of the back is one geodesic, that of the princess front two halves of it.
    body, definitions = bm.load_sample("female_average"), load_pattern("princess")
    landmarks = panel_landmarks(body, definitions, landmarks_of(EASE))
    curves = EdgeCurves(Cloth(body, ease_of(body, EASE, landmarks)), landmarks)
    center, side, back = (
        1000.0 * curves.on_cloth(edge).length
        for panel in definitions.panel
        for edge in panel.edge
        if edge.seam == "shoulder"
    )
    assert center + side == pytest.approx(back, abs=2e-7)


@cache
def bodice() -> bm.Pattern:
    return bm.make_pattern(bm.load_sample("male_average"), "bodice", ease=EASE)


@pytest.mark.slow
def test_pieces_with_ease_are_sound_and_their_seams_match() -> None:
    # In the armpit of this body the surface would fold but for what is done in creases.
    assert bodice().is_sound
    assert bodice().ease == EASE
    assert all(abs(seam.difference) < 1e-9 for seam in bodice().seams)
    waist = [piece.edge("waist") for piece in bodice().pieces]
    grown = 2.0 * sum(edge.length - edge.skin_length for edge in waist)
    # The curve of this seam is not level.
    assert grown == pytest.approx(0.02, abs=1.5e-3)
    for piece in bodice().pieces:
        for edge in piece.edges:
            assert edge.length == pytest.approx(edge.cloth_length, abs=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["male_average", "female_old", "female_full_bust"])
def test_a_closed_bodice_has_the_girth_of_the_bust_with_its_ease(name: str) -> None:
    # The second one has a crease between the breasts, where a mesh of 8 mm is 5 mm short.
    body = bm.load_sample(name)
    pattern = bodice() if name == "male_average" else bm.make_pattern(body, "bodice", ease=EASE)
    up, at = body.axes.up_vector, body.landmarks["bust point left"]
    whole = 0.0
    for piece in pattern.pieces:
        mesh = piece.flat.mesh
        skin = evaluate(body.control_points[mesh.places.patch], mesh.places.parameters)
        line = level_line(mesh, (skin - body.position(at)) @ up)
        assert line is not None
        # Without the condition that it keeps its length, the piece would give there.
        whole += 2.0 * line.measured(piece.flat.positions)
    assert whole == pytest.approx(loop_length(Cloth(body), at) + 0.04, abs=5e-4)


@pytest.mark.slow
def test_a_bodice_that_bridges_hollows_has_the_girth_of_the_tape_with_its_ease() -> None:
    body = bm.load_sample("female_average")
    up, at = body.axes.up_vector, body.position(body.landmarks["bust point left"])
    tape = convex_hull(plane_section(body, bm.Plane(at, up)).nearest(at)).length
    whole = 0.0
    for piece in bm.make_pattern(body, "bodice", ease=EASE, bridge=True).pieces:
        mesh = piece.flat.mesh
        skin = evaluate(body.control_points[mesh.places.patch], mesh.places.parameters)
        line = level_line(mesh, (skin - at) @ up)
        assert line is not None
        whole += 2.0 * line.measured(piece.flat.positions)
    # The section itself is 8 mm longer than the tape.
    assert whole == pytest.approx(tape + 0.04, abs=1e-3)


def test_a_set_has_ease_of_its_own(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    text = 'format = "bodymeasure pattern"\nversion = 1\nname = "Mine"\nextends = "skirt"\n'
    path.write_text(text + "ease = {hip = 0.06}\n")
    assert load_pattern(path).ease == {"hip": 0.06}
    path.write_text(text + "ease = {hip = 6.0}\n")
    with pytest.raises(bm.InputError, match=r"mine.toml: ease at 'hip' is 6.0; expected .*meters"):
        load_pattern(path)


@pytest.mark.parametrize(
    ("ease", "words"),
    [
        ({"hip": 0.04}, "asked for at 'hip', which is no landmark"),
        ({"m": 4.0}, "ease at 'm' is 4.0; expected .* in meters"),
        ({"m": "4cm"}, "expected by how much the girth there is wider"),
        ([0.04], "expected a mapping of levels"),
        ({"a": 0.01, "b": 0.02, "m": 0.03}, r"whose heights differ by less than 1 cm"),
    ],
)
def test_eases_that_make_no_sense_are_named(ease: object, words: str) -> None:
    body = interpolated(cylinder)
    near = {**body.landmarks, "b": bm.AtlasPoint(0, 0.8, 0.21)}
    with pytest.raises(bm.InputError, match=words):
        bm.make_pattern(replace(body, landmarks=near), four_geodesics(), ease=ease)  # type: ignore[arg-type]


def test_ease_fades_out_above_the_bust_by_whichever_of_its_names() -> None:
    body = bm.load_sample("female_average")
    definitions, offsets = load_pattern("bodice"), []
    for name in ("bust", "bust point left", "bust point right"):
        given = {name: 0.04, "waist": 0.02}
        landmarks = panel_landmarks(body, definitions, landmarks_of(given))
        ease = ease_of(body, given, landmarks)
        assert ease is not None
        offsets.append(ease.offsets(body.position(landmarks["side neck point left"])))
    np.testing.assert_allclose(offsets, 0.0, atol=1e-15)
