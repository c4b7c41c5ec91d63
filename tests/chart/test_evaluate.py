"""Measurements of bodies whose sizes are known in closed form, and their failures."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.charts.posts import FRONT, RADIUS, chart_of, post
from helpers.surfaces.cut_atlases import corner_of, wavy_plane
from helpers.surfaces.tubes import joined, ring_length, tube

from bodymeasure.atlas import AtlasPoint, Axes
from bodymeasure.chart import (
    Definitions,
    MeasurementDefinition,
    Outcome,
    TapeKind,
    measure_chart,
)
from bodymeasure.chart.kinds import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    DepthMeasure,
    DropMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    OverMeasure,
    PathMeasure,
    TiltedGirthMeasure,
)
from bodymeasure.chart.landmarks.rules import Between

CLOSED_FORMS: list[tuple[MeasurementDefinition, float]] = [
    (HeightMeasure(key="a", name="a", at="front"), 1.5),
    (HeightMeasure(key="a", name="a", at="high front", above="low front"), 1.5),
    (HeightMeasure(key="a", name="a", at="low front", above="high front"), 1.5),
    (ChordMeasure(key="a", name="a", start="left", end="right"), 2 * RADIUS),
    (BreadthMeasure(key="a", name="a", at="front"), 2 * RADIUS),
    (DepthMeasure(key="a", name="a", at="left"), 2 * RADIUS),
    (GirthMeasure(key="a", name="a", at="front"), RADIUS * ring_length()),
    (GirthMeasure(key="a", name="a", at="front", tape="contact"), RADIUS * ring_length()),
    (GirthMeasure(key="a", name="a", at="back", cut=("left", "right")), RADIUS * ring_length()),
    (LimbGirthMeasure(key="round", name="a", start="low front", end="high front"), RADIUS),
    (
        LimbGirthMeasure(key="round", name="a", start="low front", end="high front", at="left"),
        RADIUS,
    ),
    (PathMeasure(key="a", name="a", through=("low front", "high front")), 1.5),
    (PathMeasure(key="round", name="a", through=("right", "front", "left")), RADIUS / 2),
    (ClosedMeasure(key="round", name="a", at="front"), RADIUS),
    (PathMeasure(key="a", name="a", through=("front", "high front", "low front")), 2.25),
    (DropMeasure(key="a", name="a", start="high front", level="low left"), 1.5),
    (DropMeasure(key="a", name="a", start="low left", level="high front", plane="side"), 1.5),
]


@pytest.mark.parametrize(("measurement", "expected"), CLOSED_FORMS)
def test_closed_forms(measurement: MeasurementDefinition, expected: float) -> None:
    if measurement.key == "round":
        expected *= ring_length()
    (found,) = chart_of(post(), [measurement]).measured
    assert found.outcome is Outcome.MEASURED, found.reason
    assert abs(found.value - expected) <= found.error_estimate + 1e-12
    assert found.error_estimate < 1e-5 * expected
    for tape in found.tapes:
        assert tape.points.shape == tape.normals.shape
        drawn = np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum()
        assert drawn == pytest.approx(expected, rel=2e-3)
        if tape.kind is not TapeKind.STRAIGHT:
            np.testing.assert_allclose(np.linalg.norm(tape.normals, axis=1), 1.0, atol=1e-12)
            # The landmarks are away from the axis; the sections are round but for some per cent.
            outwards = tape.points[:, :2] / np.linalg.norm(tape.points[:, :2], axis=1)[:, None]
            assert ((tape.normals[:, :2] * outwards).sum(axis=1) > 0.9).all()
        else:
            assert not tape.normals.any()


def test_kinds_of_tapes() -> None:
    (path, girth, chord) = chart_of(
        post(),
        [
            PathMeasure(key="a", name="a", through=("right", "front", "left")),
            GirthMeasure(key="b", name="b", at="front"),
            ChordMeasure(key="c", name="c", start="left", end="right"),
        ],
    ).measured
    assert [tape.kind for tape in path.tapes] == [TapeKind.CONTACT]
    assert [tape.kind for tape in girth.tapes] == [TapeKind.CONTACT, TapeKind.TAUT]
    assert [tape.kind for tape in chord.tapes] == [TapeKind.STRAIGHT]
    # A closed tape ends where it starts.
    for tape in girth.tapes:
        np.testing.assert_array_equal(tape.points[0], tape.points[-1])
    assert path.landmarks == ("right", "front", "left")
    assert path.status == "CONVERGED"
    assert path.length_by_region == {"torso": pytest.approx(path.contact, rel=1e-9)}
    assert girth.length_by_region == {"torso": pytest.approx(girth.contact, rel=1e-12)}


def test_a_taut_tape_that_there_is_not_leaves_what_was_asked_for() -> None:
    # A tube open at both ends encloses nothing.
    ends = ("right", "left")
    both, taut = chart_of(
        post(),
        [
            PathMeasure(key="a", name="a", through=ends, tape="both"),
            PathMeasure(key="b", name="b", through=ends, tape="taut"),
        ],
    ).measured
    assert both.outcome is Outcome.MEASURED
    assert both.value == pytest.approx(RADIUS * ring_length() / 2.0)
    assert np.isnan(both.taut)
    assert both.reason.startswith("There is no taut length: the outside of patch 'patch 0' and 3 m")
    assert taut.outcome is Outcome.REFUSED
    assert np.isnan(taut.value)
    assert "cannot be determined" in taut.reason


def test_a_tilted_girth_lies_in_the_plane_of_its_landmarks() -> None:
    found = chart_of(
        post(), [TiltedGirthMeasure(key="a", name="a", through=("front", "high back"))]
    )["a"]
    (contact, _) = found.tapes
    # Half as far up at the sides, which lie halfway from front to back.
    sides = contact.points[np.abs(contact.points[:, 1]) < 1e-9]
    np.testing.assert_allclose(sides[:, 2], 1.875, atol=1e-9)
    assert found.value > RADIUS * ring_length()
    beside = chart_of(post(), [TiltedGirthMeasure(key="a", name="a", through=("left", "right"))])[
        "a"
    ]
    assert beside.outcome is Outcome.REFUSED
    assert "lie one beside the other or at one place" in beside.reason


def test_a_tilted_girth_may_be_level_from_front_to_back() -> None:
    found = chart_of(
        post(),
        [
            TiltedGirthMeasure(key="a", name="a", through=("left", "right"), plane="median"),
            TiltedGirthMeasure(key="b", name="b", through=("front", "back"), plane="median"),
        ],
    )
    assert found["a"].value == pytest.approx(RADIUS * ring_length())
    assert "lie one before the other or at one place" in found["b"].reason


def test_a_tilted_girth_passes_both_of_its_landmarks() -> None:
    legs = joined([tube([1.0] * 4), tube([1.0] * 4, (-3.0, 0.0))], ["leg left", "leg right"])
    here, there = AtlasPoint(0, 0.0, 0.5), AtlasPoint(4, 0.0, 0.6)
    found = chart_of(
        replace(legs, landmarks={"here": here, "there": there}),
        [TiltedGirthMeasure(key="a", name="a", through=("here", "there"), plane="median")],
    )["a"]
    assert found.outcome is Outcome.REFUSED
    assert "the loop at 'here' does not pass 'there'" in found.reason


def test_an_extreme_girth_at_the_end_of_its_stretch_says_so() -> None:
    atlas = post((1.0, 1.0, 1.0, 2.0))
    inside = ExtremeGirthMeasure(
        key="a", name="a", start="low front", end="high front", extreme="largest"
    )
    found = chart_of(atlas, [inside])["a"]
    # The radius is a cubic from 1 to 2 that starts level: 1 + v^3.
    assert found.value == pytest.approx((1.0 + 0.75**3) * ring_length(), rel=1e-9)
    assert found.outcome is Outcome.MEASURED
    assert found.reason.startswith("The extreme is at the end of the stretch: a more extreme girth")


@pytest.mark.parametrize("out", [0.5, 0.02])
def test_over_a_tape_between_two_others(out: float) -> None:
    # Two thin posts beside the trunk stand out to the front, and a tape from one to the other.
    posts = [tube((0.25,) * 4, (x, -RADIUS - out + 0.25)) for x in (-2.5, 2.5)]
    atlas = joined([tube((RADIUS,) * 4), *posts], ["torso", "breast", "breast"])
    landmarks = {
        "high": AtlasPoint(FRONT, 0.0, 0.75),
        "low": AtlasPoint(FRONT, 0.0, 0.25),
        "left": AtlasPoint(8 + FRONT, 0.0, 0.5),
        "right": AtlasPoint(4 + FRONT, 0.0, 0.5),
    }
    over = OverMeasure(key="a", name="a", start="high", level="low", over=("left", "right"))
    found = chart_of(replace(atlas, landmarks=landmarks), [over])["a"]
    assert found.outcome is Outcome.MEASURED, found.reason
    assert found.value == pytest.approx(2.0 * np.hypot(0.75, out), rel=1e-12)
    (tape,) = found.tapes
    np.testing.assert_allclose(tape.points[1], (0.0, -RADIUS - out, 1.5), atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(tape.normals, axis=1), (1.0, 0.0, 1.0))


def test_over_a_bulging_body_the_tape_follows_it() -> None:
    # The radius is 1.5 in the middle and 1 at the ends: the tape touches the tube from start to
    # end.
    atlas = post((1.0, 1.6, 1.6, 1.0))
    over = OverMeasure(
        key="a", name="a", start="high front", level="low front", over=("left", "right")
    )
    drop = DropMeasure(key="b", name="b", start="high front", level="low front")
    chart = chart_of(atlas, [over, drop])
    # A parabola of height, and so its arc in closed form: r = 1 + 1.8 v (1 - v), z = 3 v.
    slope = 1.8 * 0.5 / 3.0
    arc = 1.5 * 0.5 * (np.sqrt(1.0 + slope**2) + np.arcsinh(slope) / slope)
    assert chart["b"].value == pytest.approx(arc, rel=1e-12)
    assert abs(chart["a"].value - arc) <= chart["a"].error_estimate
    assert chart["a"].error_estimate < 1e-7 * arc


def test_formulas_take_what_was_measured() -> None:
    chart = chart_of(
        post(),
        [
            FormulaMeasure(key="twice", name="twice", formula="2 * sum"),
            FormulaMeasure(key="sum", name="sum", formula="girth + way"),
            GirthMeasure(key="girth", name="girth", at="front"),
            PathMeasure(key="way", name="way", through=("front", "left")),
            FormulaMeasure(key="slope", name="slope", formula="atan(way / way)", angle=True),
        ],
    )
    girth, way, total = chart["girth"], chart["way"], chart["sum"]
    assert total.value == girth.value + way.value
    assert total.error_estimate == girth.error_estimate + way.error_estimate
    assert chart["twice"].value == 2.0 * total.value
    assert chart["slope"].value == pytest.approx(45.0)
    assert total.landmarks == ("front", "left")
    assert np.isnan(total.contact)
    # Pictures show what it is made of.
    assert total.tapes == (*girth.tapes, *way.tapes)
    # The order is that of the definitions, whatever was measured first.
    keys = [one.definition.key for one in chart.measured]
    assert keys == ["twice", "sum", "girth", "way", "slope"]


def test_landmarks_by_rule_are_measured_from() -> None:
    rule = Between(name="eighth", start="front", end="left")
    chart = chart_of(post(), [PathMeasure(key="a", name="a", through=("front", "eighth"))], [rule])
    assert chart["a"].value == pytest.approx(RADIUS * ring_length() / 8.0, rel=1e-9)
    assert set(chart.landmarks) == {*post().landmarks, "eighth"}


def test_paths_on_a_plane_are_chords(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    landmarks = {
        name: corner_of(atlas, position)
        for name, position in (("a", (0, 0, 0)), ("b", (3, 2, 0)), ("c", (1, 3, 0)))
    }
    # Up along y, so that heights are its coordinates.
    atlas = replace(atlas, landmarks=landmarks, axes=Axes("+y", "+z"))
    chart = chart_of(
        atlas,
        [
            PathMeasure(key="way", name="way", through=("a", "b", "c")),
            PathMeasure(key="back", name="back", through=("a", "b")),
            HeightMeasure(key="height", name="height", at="b"),
        ],
    )
    assert chart["way"].value == pytest.approx(np.sqrt(13.0) + np.sqrt(5.0), rel=1e-9)
    # The one leg is a part of the other measurement, and found once.
    assert chart["back"].value == pytest.approx(np.sqrt(13.0), rel=1e-9)
    assert chart["height"].value == 2.0
    # Regions without names are not used to check girths.
    assert chart["way"].length_by_region == {"": pytest.approx(chart["way"].value)}


def test_progress_is_told() -> None:
    told: list[tuple[int, int]] = []
    definitions = Definitions(
        format="bodymeasure measurements",
        version=1,
        name="Test",
        measurement=(
            HeightMeasure(key="a", name="a", at="front"),
            FormulaMeasure(key="b", name="b", formula="a + a"),
        ),
    )
    chart = measure_chart(post(), definitions, progress=lambda done, of: told.append((done, of)))
    assert told == [(1, 2), (2, 2)]
    assert chart.seconds > 0.0
    assert "numpy" in chart.versions
    with pytest.raises(KeyError):
        chart["c"]
