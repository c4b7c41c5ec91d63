"""Parts of girths: halves of rings, hollows at their ends, and mistakes."""

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest
from helpers.speed import quick
from helpers.surfaces.tubes import joined, ring_length, tube
from msgspec.structs import replace as replaced

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import (
    Chart,
    Definitions,
    Measured,
    MeasurementDefinition,
    Outcome,
    TapeKind,
    load_definitions,
    measure_chart,
)
from bodymeasure.chart.kinds import GirthArcMeasure, GirthMeasure
from bodymeasure.errors import InputError
from bodymeasure.measure import body_girth, girth_arc
from bodymeasure.samples import load_sample
from bodymeasure.section import BridgedLoop

RADIUS = 1.5
# Directions of the tube's patches where u = 0: to the left, back, right and front.
LEFT, BACK, RIGHT, FRONT = range(4)
Side = Literal["front", "back"]
SIDES: tuple[Side, Side] = ("front", "back")


def post() -> Atlas:
    landmarks = {
        name: AtlasPoint(patch, 0.0, 0.5)
        for name, patch in (("left", LEFT), ("back", BACK), ("right", RIGHT), ("front", FRONT))
    }
    # This landmark is not at the arc's height.
    landmarks["low left"] = AtlasPoint(LEFT, 0.0, 0.25)
    # These are halfway from the front to the left, and to the right.
    landmarks["front left"] = AtlasPoint(FRONT, 0.5, 0.5)
    landmarks["front right"] = AtlasPoint(RIGHT, 0.5, 0.5)
    return replace(joined([tube((RADIUS,) * 4)], ["torso"]), landmarks=landmarks)


def arc_of(
    ends: tuple[str, str], side: Side, *, cut: tuple[str, str] | None = None
) -> tuple[Measured, Chart]:
    arc = GirthArcMeasure(
        key="a", name="a", at="front", start=ends[0], end=ends[1], side=side, tape="both", cut=cut
    )
    definitions = Definitions(
        format="bodymeasure measurements", version=1, name="Test", measurement=(arc,)
    )
    chart = measure_chart(post(), definitions)
    return chart["a"], chart


@pytest.mark.parametrize(
    ("ends", "side", "share"),
    [
        (("left", "right"), "front", 0.5),
        (("left", "right"), "back", 0.5),
        (("right", "left"), "front", 0.5),
        (("low left", "right"), "back", 0.5),
        (("front left", "front right"), "front", 0.25),
        (("front left", "front right"), "back", 0.75),
        (("front right", "front left"), "back", 0.75),
        (("left", "front right"), "front", 0.375),
    ],
)
def test_parts_of_a_ring(ends: tuple[str, str], side: Side, share: float) -> None:
    found, chart = arc_of(ends, side)
    assert found.outcome is Outcome.MEASURED, found.reason
    expected = share * RADIUS * ring_length()
    for length in (found.value, found.contact, found.taut):
        assert abs(length - expected) <= found.error_estimate
    assert found.error_estimate < 1e-6 * expected
    assert found.landmarks == ("front", *ends)
    assert found.length_by_region == {"torso": pytest.approx(expected, rel=1e-9)}
    assert [tape.kind for tape in found.tapes] == [TapeKind.CONTACT, TapeKind.TAUT]
    for tape in found.tapes:
        np.testing.assert_allclose(tape.points[:, 2], 1.5, atol=1e-12)
        drawn = np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum()
        assert drawn == pytest.approx(expected, rel=2e-3)
        np.testing.assert_allclose(np.linalg.norm(tape.normals, axis=1), 1.0, atol=1e-12)
        # The tape runs from one of the ends to the other.
        first, last = (chart.atlas.position(chart.landmarks[name])[:2] for name in ends)
        meet = np.array([tape.points[0, :2], tape.points[-1, :2]])
        apart = min(np.abs(meet - [first, last]).max(), np.abs(meet - [last, first]).max())
        assert apart < 1e-7


def test_a_girth_that_needs_no_cut_is_left_whole() -> None:
    found, _ = arc_of(("left", "right"), "front", cut=("left", "right"))
    assert found.value == pytest.approx(0.5 * RADIUS * ring_length(), rel=1e-7)
    assert found.landmarks == ("front", "left", "right")


@pytest.mark.parametrize(
    ("ends", "said"),
    [
        (("front", "back"), "neither is the front one; choose ends at the left and at the right"),
        (("low left", "left"), "both ends of the arc are at one place of the girth"),
        (("lfet", "right"), "the atlas has no landmark 'lfet'"),
    ],
)
def test_arcs_that_are_none_are_refused(ends: tuple[str, str], said: str) -> None:
    found, _ = arc_of(ends, "front")
    assert found.outcome is not Outcome.MEASURED
    assert said in found.reason
    assert np.isnan(found.value)


def test_in_a_hollow_the_taut_part_ends_on_its_bridge() -> None:
    # The hollow between the breasts is spanned by a line from left to right.
    body = load_sample("female_average")
    girth = body_girth(body, "bust point left")
    widest = np.argmax(np.linalg.norm(girth.bridges[:, 1] - girth.bridges[:, 0], axis=1))
    first, last = girth.hull.spans[widest]
    places = first + (last - first) * np.array([0.4, 0.7])
    start, end = girth.loop.positions_at(places)
    front, back = (girth_arc(girth, start, end, body.axes.front_vector, side) for side in SIDES)
    across = abs(float((start - end) @ body.axes.left_vector))
    assert front.taut == pytest.approx(across, rel=1e-9)
    assert front.contact > 1.005 * across
    assert front.taut + back.taut == pytest.approx(girth.taut, rel=1e-12)
    assert front.contact + back.contact == pytest.approx(girth.contact, rel=1e-12)
    # Neither end is on the skin, and the bridge between them has nothing else to lie on.
    assert front.taut_tape.patch.tolist() == [-1, -1]
    assert (back.taut_tape.patch[1:-1] >= 0).all()
    for arc in (front, back):
        drawn = np.linalg.norm(np.diff(arc.taut_tape.positions, axis=0), axis=1).sum()
        assert drawn == pytest.approx(arc.taut, rel=1e-3)


def test_a_side_has_to_be_known() -> None:
    atlas = post()
    girth = body_girth(atlas, "front")
    start, end = (atlas.position(atlas.landmarks[name]) for name in ("left", "right"))
    with pytest.raises(InputError, match="side is 'top'; expected 'front' or 'back'"):
        girth_arc(girth, start, end, atlas.axes.front_vector, "top")  # type: ignore[arg-type]


DEFAULT = load_definitions()
PAIRS = {"bust": "bust_girth", "waist": "waist_girth", "hip": "hip_girth"}


def chart_of(part: str, tape: Literal["contact", "taut"]) -> Chart:
    keys = {*(f"{part}_{side}_arc" for side in SIDES), PAIRS[part]}
    kept: list[MeasurementDefinition] = []
    for one in DEFAULT.measurement:
        if isinstance(one, GirthArcMeasure | GirthMeasure) and one.key in keys:
            members = {name: getattr(one, name) for name in one.__struct_fields__}
            kept.append(type(one)(**{**members, "tape": tape}))
    definitions = Definitions(
        format=DEFAULT.format,
        version=1,
        name="Arcs",
        landmark=DEFAULT.landmark,
        measurement=tuple(kept),
    )
    # Asked for by name, they have only the landmarks found that they need.
    return measure_chart(load_sample("female_average"), definitions, only=sorted(keys))


@pytest.mark.parametrize("tape", [pytest.param("contact", marks=pytest.mark.slow), "taut"])
@pytest.mark.parametrize("part", quick(["waist", "bust", "hip"]))
def test_front_and_back_are_the_girth(part: str, tape: Literal["contact", "taut"]) -> None:
    chart = chart_of(part, tape)
    front, back, girth = (
        chart[key] for key in (f"{part}_front_arc", f"{part}_back_arc", PAIRS[part])
    )
    assert front.value + back.value == pytest.approx(girth.value, rel=1e-9)
    assert front.taut < front.contact + front.error_estimate
    by_region = [sum(one.length_by_region.values()) for one in (front, back)]
    assert by_region == pytest.approx([front.contact, back.contact], rel=1e-6)
    up = chart.atlas.axes.up_vector
    for one in (front, back):
        for lying in one.tapes:
            assert np.ptp(lying.points @ up) < 1e-9
            drawn = np.linalg.norm(np.diff(lying.points, axis=0), axis=1).sum()
            lengths = {TapeKind.CONTACT: one.contact, TapeKind.TAUT: one.taut}
            assert drawn == pytest.approx(lengths[lying.kind], rel=2e-3)
    ahead = chart.atlas.axes.front_vector
    assert (front.tapes[0].points @ ahead).mean() > (back.tapes[0].points @ ahead).mean()


@pytest.mark.slow
def test_arcs_of_a_girth_cut_at_the_armpits() -> None:
    # Above the armpits the loop goes around the trunk and the arms.
    kept = [
        GirthArcMeasure(
            key=side,
            name=side,
            at="armhole level point left",
            start="side bust point left",
            end="side bust point right",
            side=side,
            tape="contact",
            cut=("armpit point left", "armpit point right"),
        )
        for side in SIDES
    ]
    definitions = replaced(DEFAULT, measurement=tuple(kept))
    body = load_sample("female_average")
    chart = measure_chart(body, definitions)
    front, back = chart.measured
    at, *cut = (
        chart.landmarks[name]
        for name in ("armhole level point left", "armpit point left", "armpit point right")
    )
    girth = body_girth(body, at, cut=(cut[0], cut[1]))
    assert isinstance(girth.tape, BridgedLoop)
    assert front.value + back.value == pytest.approx(girth.contact, rel=1e-12)
    # The straight lines over the cuts lie in no region.
    regions = [sum(one.length_by_region.values()) for one in (front, back)]
    lines = np.linalg.norm(girth.tape.bridges[:, 1] - girth.tape.bridges[:, 0], axis=1).sum()
    assert sum(regions) == pytest.approx(girth.contact - lines, rel=1e-9)
