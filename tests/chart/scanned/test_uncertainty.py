"""What values on a scanned body owe to the scan, and what the scan does not show."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.charts.scanned import LANDMARKS, SURFACE, scanned

from bodymeasure import (
    Atlas,
    AtlasPoint,
    Chart,
    LandmarkFound,
    LandmarkOrigin,
    Outcome,
    load_sample,
    measure_chart,
)
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.closest import closest_points

SAMPLE = load_sample("female_average")
WHOLE = scanned(SAMPLE)
# One of each kind that is quick to measure.
KEYS = (
    "waist_girth", "hip_girth", "waist_front_arc", "knee_girth_left", "bust_breadth",
    "waist_depth", "bust_span", "waist_to_hip_left", "back_neck_to_waist", "shoulder_chord_left",
    "knee_height_left", "outer_leg_length_left", "shoulder_slope_left",
)  # fmt: skip


def charted(atlas: Atlas, *keys: str) -> Chart:
    return measure_chart(atlas, only=keys)


@pytest.mark.slow
def test_a_tape_between_carried_landmarks_is_as_good_as_they_are() -> None:
    span = charted(WHOLE, "bust_span")["bust_span"]
    assert span.error_estimate < 1e-7
    # Both ends lie off by 5 mm in the plane of the skin, so that each adds 5 / sqrt(2) along it.
    assert span.input_uncertainty == pytest.approx(LANDMARKS, rel=0.02)
    assert "scan 0.005" in repr(span)
    exact = charted(scanned(SAMPLE, landmarks=0.0), "bust_span")["bust_span"]
    assert exact.surface_uncertainty < SURFACE
    assert exact.input_uncertainty == pytest.approx(exact.surface_uncertainty, rel=1e-2)
    assert charted(SAMPLE, "bust_span")["bust_span"].input_uncertainty is None


def test_a_picked_landmark_is_better_than_a_carried_one() -> None:
    assert WHOLE.scan is not None
    picked = LandmarkFound(LandmarkOrigin.PICKED, 0.001)
    landmarks = {**WHOLE.scan.landmarks, "patella point left": picked}
    body = replace(WHOLE, scan=replace(WHOLE.scan, landmarks=landmarks))
    chart = charted(body, "knee_height_left", "knee_height_right")
    # The skin of a kneecap is nearly upright.
    left, right = (chart[f"knee_height_{side}"].input_uncertainty for side in ("left", "right"))
    assert left == pytest.approx(0.001 / np.sqrt(2.0), rel=0.05)
    assert right == pytest.approx(0.005 / np.sqrt(2.0), rel=0.02)


def test_uncertainties_are_in_the_unit_of_the_atlas() -> None:
    keys = ("waist_girth", "bust_breadth", "knee_height_left")
    meters, millimeters = charted(WHOLE, *keys), charted(WHOLE.converted("mm"), *keys)
    for key in keys:
        one, other = meters[key].input_uncertainty, millimeters[key].input_uncertainty
        assert one is not None
        assert other == pytest.approx(1000.0 * one, rel=1e-9)


def test_a_formula_knows_what_its_operands_share() -> None:
    # A hip landmark that lies lower makes the way down to it longer, and the rest shorter.
    chart = charted(WHOLE, "outer_leg_length_left", "waist_to_hip_left", "hip_height_left")
    whole, way, rest = (
        chart[key].input_uncertainty
        for key in ("outer_leg_length_left", "waist_to_hip_left", "hip_height_left")
    )
    assert whole is not None
    assert way is not None
    assert rest is not None
    assert whole < 0.8 * way < way < np.hypot(way, rest)


def test_what_the_scan_does_not_show_has_no_number() -> None:
    arm = [i for i, name in enumerate(SAMPLE.regions) if name in ("upper arm left", "forearm left")]
    assert arm
    chart = charted(scanned(SAMPLE, arm), "elbow_girth_left", "elbow_girth_right", "waist_girth")
    missing = chart["elbow_girth_left"]
    assert missing.outcome is Outcome.NOT_SCANNED
    assert np.isnan(missing.value)
    assert "the scan shows nothing at 'wrist point left' (forearm left)" in missing.reason
    assert [chart[key].outcome for key in ("elbow_girth_right", "waist_girth")] == ["measured"] * 2


def test_a_hole_below_a_tape_is_named() -> None:
    chart = charted(WHOLE, "waist_girth")
    points = chart["waist_girth"].tape.points
    places, _ = closest_points(SAMPLE, points[points @ SAMPLE.axes.front_vector < 0.0][:1])
    hole = places[0].patch
    found = charted(scanned(SAMPLE, [hole]), "waist_girth", "waist_breadth")
    for key in ("waist_girth", "waist_breadth"):
        assert found[key].outcome is Outcome.NOT_SCANNED
        assert f"shows less than half: {SAMPLE.patch_names[hole]}" in found[key].reason


def test_what_follows_from_an_unseen_landmark_has_no_number_either() -> None:
    knee = SAMPLE.landmarks["patella point left"].patch
    chart = charted(scanned(SAMPLE, [knee]), "mid_thigh_girth_left", "mid_thigh_girth_right")
    reason = chart["mid_thigh_girth_left"].reason
    assert (
        "nothing at 'patella point left' (knee left), which 'mid-thigh point left' follows from"
        in reason
    )
    assert chart["mid_thigh_girth_right"].outcome is Outcome.MEASURED


def shaken(rng: np.random.Generator) -> Atlas:
    """The body with a bumpy surface and with landmarks off their places, as a fit leaves them."""
    points = SAMPLE.points
    centers = rng.uniform(points.min(axis=0), points.max(axis=0), (1500, 3))
    # A smooth random field whose values 5 cm apart are independent.
    field = np.zeros(len(points))
    for center, weight in zip(centers, rng.normal(size=len(centers)), strict=True):
        field += weight * np.exp(-((points - center) ** 2).sum(axis=1) / (2.0 * 0.025**2))
    field *= SURFACE / field.std()
    corner = np.zeros((len(points), 3))
    side = np.linspace(0.0, 1.0, 4)
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    nets = SAMPLE.control_points
    normals = unit_normals(nets, np.broadcast_to(grid.reshape(1, 16, 2), (len(nets), 16, 2)))
    corner[SAMPLE.index.reshape(len(nets), 16)] = normals
    body = replace(SAMPLE, points=points + field[:, None] * corner)
    moved: dict[str, AtlasPoint] = {}
    for name, point in body.landmarks.items():
        normal = unit_normals(body.control_points[[point.patch]], np.array([[point[1:]]]))[0, 0]
        move = rng.normal(scale=LANDMARKS / np.sqrt(2.0), size=3)
        places, _ = closest_points(
            body, (body.position(point) + move - (move @ normal) * normal)[None]
        )
        moved[name] = places[0]
    return replace(body, landmarks=moved)


@pytest.mark.slow
def test_true_errors_are_within_twice_the_uncertainty_as_often_as_they_should_be() -> None:
    rng = np.random.default_rng(11)
    stated = charted(WHOLE, *KEYS)
    ratios = []
    for _ in range(12):
        chart = charted(shaken(rng), *KEYS)
        for key in KEYS:
            uncertainty = stated[key].input_uncertainty
            assert uncertainty is not None
            ratios.append((chart[key].value - stated[key].value) / uncertainty)
    inside = np.mean(np.abs(ratios) < 2.0)
    # 95 % of a normal distribution, and not so wide that everything were inside.
    assert 0.9 < inside <= 1.0
    assert 0.7 < np.sqrt(np.mean(np.square(ratios))) < 1.25
