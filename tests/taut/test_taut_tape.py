from dataclasses import replace
from fractions import Fraction
from itertools import combinations, pairwise

import numpy as np
import pytest
from helpers.body_space import random_body
from helpers.oracles.profiles import profile_hull
from helpers.speed import quick
from helpers.surfaces.extruded_surfaces import CUBIC, RIDGE, at, row_of
from helpers.surfaces.surfaces import bicubic

import bodymeasure as bm
from bodymeasure.taut import starts, string
from bodymeasure.taut.skin import skin_of
from bodymeasure.taut.solve import draw_taut

SIDES = ("left", "right")


@pytest.fixture(scope="module")
def body() -> bm.Atlas:
    return bm.load_sample("female_average")


def pair(body: bm.Atlas, first: str, second: str) -> tuple[bm.AtlasPoint, bm.AtlasPoint]:
    return body.landmarks[first], body.landmarks[second]


def between(body: bm.Atlas, *names: str) -> bm.TautTape:
    start, *via, end = (body.landmarks[name] for name in names)
    return bm.taut_tape(body, start, end, via)


def test_from_bust_to_bust_it_bridges_the_hollow(body: bm.Atlas) -> None:
    tape = between(body, "bust point left", "bust point right")
    assert tape.chord < tape.length < tape.contact.length
    assert tape.gap == tape.contact.length - tape.length > 0.005
    assert tape.unit is body.unit
    assert tape.error_estimate < 1e-7
    # The tape is free in the middle, and on the skin at both ends.
    middle = len(tape.points) // 2
    assert not tape.touching[middle]
    assert tape.touching[[0, -1]].all()
    for place, name in ((0, "bust point left"), (-1, "bust point right")):
        np.testing.assert_allclose(tape.points[place], body.position(body.landmarks[name]))


@pytest.mark.slow
def test_the_polygon_is_nearly_as_long_and_never_inside_the_body(body: bm.Atlas) -> None:
    tape = between(body, "back neck point", "front waist point")
    chords = np.linalg.norm(np.diff(tape.points, axis=0), axis=1)
    assert 0.0 <= tape.length - chords.sum() < 1e-4 * tape.length
    feet = skin_of(body, "determined").feet(tape.points)
    assert feet.depth.max() < 1e-7
    np.testing.assert_allclose(np.linalg.norm(tape.normals[tape.touching], axis=1), 1.0)
    assert np.abs(feet.gap[tape.touching]).max() < 1e-7


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_full_bust", "male_average"])
def test_it_is_between_chord_and_contact_for_all_landmarks(name: str) -> None:
    body = bm.load_sample(name)
    for start, end in combinations(list(body.landmarks.values())[:10], 2):
        tape = bm.taut_tape(body, start, end, on_failure="status")
        assert tape.converged
        path = tape.contact
        along = path.length if path.converged else path.raw_length
        assert tape.chord <= tape.length <= along
        assert tape.error_estimate < 1e-5 * tape.length


@pytest.mark.parametrize(
    "name", ["female_average", pytest.param("male_average", marks=pytest.mark.slow)]
)
@pytest.mark.parametrize(
    "ends",
    quick([("front neck point", "front waist point"), ("back neck point", "back waist point")]),
)
def test_on_the_center_lines_it_is_the_hull_of_the_profile(
    name: str, ends: tuple[str, str]
) -> None:
    body = bm.load_sample(name)
    start, end = (body.landmarks[end] for end in ends)
    tape = bm.taut_tape(body, start, end, on_failure="status")
    assert tape.length == pytest.approx(profile_hull(body, start, end), rel=2e-7)
    # It may slide off a ridge that runs down the middle, and save a little.
    assert np.abs(tape.points[:, 0]).max() < 1e-4


@pytest.mark.parametrize(
    "ends",
    [
        pytest.param(("back neck point", "bust point left"), marks=pytest.mark.slow),
        ("shoulder point left", "elbow point left"),
    ],
)
def test_mirror_images_are_equal(body: bm.Atlas, ends: tuple[str, str]) -> None:
    names = [[name.replace("left", side) for name in ends] for side in SIDES]
    one, other = (between(body, *image).length for image in names)
    assert one == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize("far", [pytest.param(-1e-4, marks=pytest.mark.slow), 0.02])
def test_where_the_string_starts_does_not_matter(body: bm.Atlas, far: float) -> None:
    tape = between(body, "back neck point", "front waist point")
    skin = skin_of(body, "determined")
    nodes = tape.contact.position(np.linspace(0.0, 1.0, 41))
    nodes[1:-1] += far * skin.feet(nodes[1:-1]).normal
    assert draw_taut(skin, nodes).length == pytest.approx(tape.length, rel=1e-6)


@pytest.mark.slow
def test_swapped_ends(body: bm.Atlas) -> None:
    there = between(body, "bust point left", "side waist point right")
    back = between(body, "side waist point right", "bust point left")
    assert abs(there.length - back.length) <= there.error_estimate + back.error_estimate
    assert there.length == pytest.approx(back.length, rel=1e-6)


def test_moved_turned_and_scaled(body: bm.Atlas) -> None:
    turn, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    ends = pair(body, "shoulder point left", "side waist point left")
    known = bm.taut_tape(body, *ends).length
    moved = bm.taut_tape(replace(body, points=body.points @ turn.T + 5.0), *ends)
    assert moved.length == pytest.approx(known, rel=1e-8)
    scaled = bm.taut_tape(body.converted("cm"), *ends)
    assert scaled.length == pytest.approx(100.0 * known, rel=1e-9)
    assert scaled.unit is bm.Unit.CM


def test_patches_that_face_inwards_change_nothing(body: bm.Atlas) -> None:
    inwards = bm.Atlas(body.points, body.index.transpose(0, 2, 1), body.unit)
    start, end = pair(body, "bust point left", "bust point right")
    known = bm.taut_tape(body, start, end).length
    swapped = (bm.AtlasPoint(point.patch, point.v, point.u) for point in (start, end))
    tape = bm.taut_tape(inwards, next(swapped), next(swapped))
    assert tape.length == pytest.approx(known, rel=1e-9)


@pytest.mark.slow
def test_through_points_between(body: bm.Atlas) -> None:
    names = ("back neck point", "shoulder point left", "elbow point left")
    tape = between(body, *names)
    legs = [between(body, *leg) for leg in pairwise(names)]
    assert tape.length == pytest.approx(sum(leg.length for leg in legs), rel=1e-8)
    assert tape.chord == pytest.approx(sum(leg.chord for leg in legs), rel=1e-14)
    shoulder = body.position(body.landmarks[names[1]])
    here = np.linalg.norm(tape.points - shoulder, axis=1) < 1e-9
    assert here.sum() == 1
    assert tape.touching[here].all()
    assert tape.contact.points == tuple(body.landmarks[name] for name in names)


def test_ends_of_legs(body: bm.Atlas) -> None:
    names = ("back neck point", "shoulder point left", "shoulder point left", "elbow point left")
    start, *via, end = (body.landmarks[name] for name in names)
    path = bm.geodesic_between(body, start, end, via)
    ends = path.leg_ends
    assert (ends[0], ends[-1]) == (0.0, 1.0)
    assert ends[1] == pytest.approx(ends[2])
    np.testing.assert_allclose(
        path.position(ends), [body.position(point) for point in path.points], atol=1e-9
    )


def test_a_known_contact_path_is_taken(body: bm.Atlas) -> None:
    start, end = (body.landmarks[f"bust point {side}"] for side in SIDES)
    path = bm.geodesic_between(body, start, end)
    tape = bm.taut_tape(body, start, end, contact=path)
    assert tape.contact is path
    assert tape.length == bm.taut_tape(body, start, end).length


def test_a_tape_of_no_length(body: bm.Atlas) -> None:
    tape = between(body, "bust point left", "bust point left")
    assert (tape.length, tape.chord, tape.gap) == (0.0, 0.0, 0.0)
    assert tape.touching.all()


def test_contact_paths_of_other_points_and_atlases_are_refused(body: bm.Atlas) -> None:
    start, end = (body.landmarks[f"bust point {side}"] for side in SIDES)
    path = bm.geodesic_between(body, start, end)
    with pytest.raises(bm.InputError, match="expected the same points in the same order"):
        bm.taut_tape(body, end, start, contact=path)
    with pytest.raises(bm.InputError, match="another atlas; expected this one"):
        bm.taut_tape(bm.load_sample("female_old"), start, end, contact=path)


def test_wrong_words_are_refused(body: bm.Atlas) -> None:
    ends = pair(body, "bust point left", "bust point right")
    with pytest.raises(
        bm.InputError, match="outside is 'up'; expected 'determined', 'along normals'"
    ):
        bm.taut_tape(body, ends[0], ends[1], outside="up")  # type: ignore[arg-type]
    with pytest.raises(bm.InputError, match="on_failure is 'ignore'; expected 'raise' or"):
        bm.taut_tape(body, ends[0], ends[1], on_failure="ignore")  # type: ignore[arg-type]


def test_points_on_separate_parts_are_refused() -> None:
    apart = bm.Atlas.from_control_points(np.stack([RIDGE, RIDGE + 5.0]), "cm")
    ends = bm.AtlasPoint(0, 0.5, 0.5), bm.AtlasPoint(1, 0.5, 0.5)
    with pytest.raises(bm.InputError, match="which no seams join: the atlas has 2 separate parts"):
        bm.taut_tape(apart, *ends, outside="along normals")


def test_an_unknown_outside_is_refused() -> None:
    sheet = row_of(CUBIC)
    with pytest.raises(
        bm.InputError, match=r"cannot be determined: .* say outside='along normals'"
    ):
        bm.taut_tape(sheet, at(sheet, -0.9, 1.0), at(sheet, 0.8, 1.0))


def test_a_string_that_does_not_come_to_rest_has_no_length(
    body: bm.Atlas, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(string, "MAX_ROUNDS", 1)
    ends = pair(body, "shoulder point left", "elbow point left")
    path = bm.geodesic_between(body, *ends)
    with pytest.raises(bm.ConvergenceError, match="The tape did not come to rest; check the atlas"):
        bm.taut_tape(body, *ends, contact=path)
    tape = bm.taut_tape(body, *ends, contact=path, on_failure="status")
    assert tape.status is bm.TautStatus.NOT_CONVERGED
    assert np.isnan(tape.length)
    assert np.isnan(tape.gap)
    assert tape.chord > 0.0
    assert tape.error_estimate == np.inf


def test_a_contact_path_without_a_length_is_said(
    body: bm.Atlas, monkeypatch: pytest.MonkeyPatch
) -> None:
    start, end = (body.landmarks[f"bust point {side}"] for side in SIDES)
    path = bm.geodesic_between(body, start, end)
    failed = replace(path, length=np.nan, status=bm.Status.NOT_CONVERGED)
    tape = bm.taut_tape(body, start, end, contact=failed)
    assert tape.status is bm.TautStatus.WITHOUT_CONTACT
    assert tape.length == pytest.approx(bm.taut_tape(body, start, end).length, rel=1e-12)
    assert np.isnan(tape.gap)
    # Without any path along the skin, the string starts from one over a mesh.
    lost = replace(failed, status=bm.Status.NO_ROUTE, pieces=())
    from_mesh = bm.taut_tape(body, start, end, contact=lost)
    assert from_mesh.status is bm.TautStatus.WITHOUT_CONTACT
    assert abs(from_mesh.length - tape.length) <= from_mesh.error_estimate + tape.error_estimate
    monkeypatch.setattr(starts, "first_ways", lambda *_: [])
    with pytest.raises(bm.ConvergenceError, match="No path along the skin was found"):
        bm.taut_tape(body, start, end, contact=lost)


@pytest.mark.slow
@pytest.mark.parametrize("number", range(5))
def test_no_tape_over_a_narrow_slot_has_a_wrong_length(number: int) -> None:
    # A tape over a slot that is cut into a plane is straight, and pinned on both of its rims.
    rim, depth, zero = Fraction(72, 10_000), Fraction(1, 10), Fraction(0)
    profile = [(Fraction(-1), zero), (-rim, zero), (-rim, -depth)]
    profile += [(-x, z) for x, z in reversed(profile)]
    nets = [
        bicubic({(0, 0): x, (1, 0): to_x - x}, {(0, 1): 3}, {(0, 0): z, (1, 0): to_z - z})
        for (x, z), (to_x, to_z) in pairwise(profile)
    ]
    atlas = row_of(*nets)
    start = bm.AtlasPoint(0, 0.9575817357244062 + 1e-3 * number, 0.4335117741068778)
    end = bm.AtlasPoint(4, 0.34341201349657435, 0.9499235525032077)
    known = float(np.linalg.norm(atlas.position(end) - atlas.position(start)))
    tape = bm.taut_tape(atlas, start, end, outside="along normals", on_failure="status")
    if tape.converged:
        assert abs(tape.length - known) <= tape.error_estimate
    else:
        assert np.isnan(tape.length)


@pytest.mark.slow
def test_a_tape_stays_on_the_shorter_side_of_a_limb() -> None:
    # From the forearm to the hand: round the other side of the forearm there is a tape, too, but it
    # is 0.626 m long.
    start = bm.AtlasPoint(323, 0.05760467757604071, 8.041408412711216e-08)
    tape = bm.taut_tape(random_body(44), start, bm.AtlasPoint(233, 1.0, 1.0))
    assert tape.converged
    assert tape.length == pytest.approx(0.559837881, abs=1e-7)
