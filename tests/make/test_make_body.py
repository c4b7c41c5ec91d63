"""Bodies made to measure: what was asked for, how sure the rest is, and what is refused."""

from functools import cache

import numpy as np
import pytest
from helpers.impossible import WOMAN

import bodymeasure as bm
from bodymeasure.errors import InputError
from bodymeasure.fit.model import body_model, coefficients_of
from bodymeasure.make import MadeBody
from bodymeasure.make.body.atlases import COUNT, atlas_of
from bodymeasure.make.body.measuring import Measuring
from bodymeasure.make.body.prior import prior_of
from bodymeasure.make.body.stature import stature_of

FEW = {"stature": 168.0, "waist_girth": 72.0, "hip_girth": 98.0}
# Four girths, six geodesics, four heights.
FOURTEEN = (
    "bust_girth", "waist_girth", "hip_girth", "knee_girth_left", "shoulder_length_left",
    "neck_base_girth", "back_neck_to_bust_left", "arm_length_left", "crotch_length",
    "waist_to_hip_left", "back_neck_height", "waist_height_left", "knee_height_left",
    "inner_leg_length",
)  # fmt: skip


def _askable(count: int) -> list[str]:
    return [one.key for one in bm.load_definitions().measurement if "{" not in one.key][:count]


@cache
def _few() -> MadeBody:
    return bm.make_body(FEW, unit="cm")


def test_the_body_has_what_was_asked_for() -> None:
    body = _few()
    chart = bm.measure_chart(body.atlas, only=list(FEW))
    for key, value in FEW.items():
        assert 100.0 * chart[key].value == pytest.approx(value, abs=2e-3)
    assert body.largest_miss < 2e-5
    assert body.rounds <= 6
    assert not body.warnings


def test_the_body_is_the_most_plausible_one() -> None:
    """No small step that leaves the measurements as they are makes it more plausible."""
    body = _few()
    slopes = Measuring(body.definitions, list(FEW)).of(body.coefficients).slopes
    b = body.coefficients
    within = np.linalg.lstsq(slopes.T, b, rcond=None)[0] @ slopes
    assert np.linalg.norm(b - within) < 1e-2 * np.linalg.norm(b)


def test_the_covariance_is_that_of_the_bodies_with_these_measurements() -> None:
    body = _few()
    slopes = Measuring(body.definitions, list(FEW)).of(body.coefficients).slopes
    gain = slopes.T @ np.linalg.inv(slopes @ slopes.T + 1e-8 * np.eye(3)) @ slopes
    assert np.abs(body.covariance - (np.eye(COUNT) - gain)).max() < 1e-6


def test_values_that_were_not_asked_for_are_less_sure() -> None:
    waist, bust, knee = _few().predicted(["waist_girth", "bust_girth", "knee_height_left"])
    assert waist.asked
    assert not bust.asked
    assert waist.deviation < 2e-4
    assert 0.01 < bust.deviation < 0.1
    assert knee.deviation < 0.02


def test_predictions_cover_as_many_bodies_as_they_say() -> None:
    """Of bodies with three measurements known, other values are as far off as is predicted."""
    keys = [*FEW, "bust_girth", "inner_leg_length", "back_neck_to_waist"]
    measuring = Measuring(_few().definitions, keys)
    mean = measuring.of(np.zeros(COUNT))
    known, asked = mean.slopes[:3], mean.slopes[3:]
    gain = asked @ known.T @ np.linalg.inv(known @ known.T)
    predicted = np.sqrt(np.diag(asked @ asked.T - gain @ known @ asked.T))
    stated = [one.deviation for one in _few().predicted(keys[3:])]
    assert np.allclose(stated, predicted, rtol=0.35)


@pytest.mark.slow
def test_a_body_outside_the_components_is_reproduced() -> None:
    found, mean = _check_held_out(5)
    assert found < 0.5 * mean


@pytest.mark.slow
def test_ten_held_out_bodies_are_reproduced() -> None:
    apart = [_check_held_out(number) for number in range(10)]
    found, mean = np.array(apart).T
    assert found.mean() < 0.014
    assert found.mean() < 0.2 * mean.mean()


def _check_held_out(number: int) -> tuple[float, float]:
    """Return how far the body that was made, and the mean body, are from the true one."""
    truth = np.random.default_rng(100 + number).normal(size=COUNT)
    values = Measuring(bm.load_definitions(), FOURTEEN).of(truth, slopes=False).values
    wanted = dict(zip(FOURTEEN, values.tolist(), strict=True))
    body = bm.make_body(wanted, unit="m", components=60)
    assert body.largest_miss < 2e-5
    assert body.rounds <= 6
    assert not body.coefficients[60:].any()
    covered = np.unique(body_model().quads[body_model().covered])
    components = body_model().components[:, covered]
    found, mean = (
        np.tensordot(b - truth, components, 1) for b in (body.coefficients, np.zeros(COUNT))
    )
    return tuple(float(np.sqrt((each**2).sum(axis=1).mean())) for each in (found, mean))  # type: ignore[return-value]


@pytest.mark.slow
def test_sex_and_age_move_the_mean_and_keep_the_measurements() -> None:
    woman = bm.make_body(FEW, unit="cm", sex="female")
    man = bm.make_body(FEW, unit="cm", sex="male", age=70)
    assert woman.largest_miss < 2e-5
    assert man.largest_miss < 2e-5
    apart = np.linalg.norm(woman.coefficients - man.coefficients)
    assert apart > 3.0
    assert man.prior.age == 70
    # The mean woman is shorter than the mean man, and between the mean body and the mannequin.
    heights = [stature_of(prior_of(sex).mean)[0] for sex in ("female", None, "male")]
    assert heights == sorted(heights)
    assert 0.05 < heights[2] - heights[0] < 0.14


@pytest.mark.slow
def test_units_may_stand_with_values() -> None:
    mixed: dict[str, float | str] = {
        "stature": "5.5118 ft",
        "waist_girth": "28 1/4 in",
        "hip_girth": 980.0,
    }
    with pytest.raises(InputError, match="is not a value; expected one such as"):
        bm.make_body(mixed, unit="mm")
    body = bm.make_body({**mixed, "stature": "1.68 m"}, unit="mm")
    assert [one.value.unit for one in body.asked] == ["m", "inch", "mm"]
    assert body.asked[1].found == pytest.approx(28.25, abs=1e-3)


@pytest.mark.slow
def test_a_key_without_its_side_is_of_the_right_side() -> None:
    body = bm.make_body({**FEW, "knee girth": 37.0, "shoulder slope": 21.0}, unit="cm")
    assert [one.value.key for one in body.asked[3:]] == ["knee_girth_right", "shoulder_slope_right"]
    assert body.asked[4].value.unit == "deg"


@pytest.mark.slow
def test_contradicting_measurements_are_met_half_way_and_said() -> None:
    """The leg's length and its parts are one sum, which these values break by 6 mm."""
    values = {
        **FEW,
        "waist_to_hip_right": 19.5,
        "hip_height_right": 84.0,
        "outer_leg_length_right": 104.1,
    }
    body = bm.make_body(values, unit="cm")
    assert 1e-3 < body.largest_miss < 4e-3
    assert any("may contradict each other by" in words for words in body.warnings)


@pytest.mark.parametrize(
    ("values", "settings", "message"),
    [
        (
            {"waist_girth": 72.0, "hip_girth": 98.0},
            {"unit": "cm"},
            "has 2 measurements; expected 3",
        ),
        (
            dict.fromkeys(_askable(41), 50.0),
            {"unit": "cm"},
            "has 41 measurements; expected 3 to 40",
        ),
        (FEW, {}, "168 has no unit, and none is guessed"),
        ({**FEW, "wast_girth": 70.0}, {"unit": "cm"}, "did you mean 'waist_girth'?"),
        ({**FEW, "foot_length": 25.0}, {"unit": "cm"}, "head, hands and feet follow"),
        ({**FEW, "head_girth": 55.0}, {"unit": "cm"}, "head, hands and feet follow"),
        ({**FEW, "waist": 72.0}, {"unit": "cm"}, "'waist_girth' is given a second time"),
        ({**FEW, "bust_girth": float("nan")}, {"unit": "cm"}, "is no number that a body has"),
        ({**FEW, "bust_girth": 10**400}, {"unit": "cm"}, "is no number that a body has"),
        ({**FEW, "bust_girth": f"{300 * '9'} cm"}, {"unit": "cm"}, "is no number that a body has"),
        ({**FEW, "bust_girth": -3.0}, {"unit": "cm"}, "is no length; expected one above zero"),
        ({**FEW, "bust_girth": None}, {"unit": "cm"}, "None is not a number"),
        ({**FEW, "bust_girth": "20 deg"}, {"unit": "cm"}, "is in deg; expected a length"),
        (FEW, {"unit": "foot"}, "foot"),
        (FEW, {"unit": "cm", "sex": "f"}, "sex is 'f'; expected 'female' or 'male'"),
        (FEW, {"unit": "cm", "age": 12}, "age is 12; expected 18 to 90 years"),
        (FEW, {"unit": "cm", "tolerance": 0.0}, "tolerance is 0.0; expected 0.001 to 50 mm"),
        (FEW, {"unit": "cm", "tolerance": "3"}, "tolerance is '3'; expected 0.001 to 50 mm"),
        (FEW, {"unit": "cm", "age": "70"}, "age is '70'; expected 18 to 90 years"),
        (FEW, {"unit": "cm", "components": 50.5}, "components is 50.5; expected 10 to 120"),
        (FEW, {"unit": "cm", "components": 4}, "components is 4; expected 10 to 120"),
        ([72.0, 98.0, 168.0], {"unit": "cm"}, "expected a mapping of keys to values"),
        ({**FEW, "waist_girth": 27.0}, {"unit": "cm"}, "swapped digits: 72 written as 27"),
    ],
)
def test_what_cannot_be_made_is_refused(
    values: object, settings: dict[str, object], message: str
) -> None:
    with pytest.raises(InputError) as caught:
        bm.make_body(values, **settings)  # type: ignore[arg-type]
    assert message in str(caught.value)


@pytest.mark.slow
def test_doubtful_bodies_are_made_if_that_is_wanted() -> None:
    body = bm.make_body({**FEW, "waist_girth": 45.0}, unit="cm", despite_doubts=True)
    assert body.probability < 1e-2
    assert "waist_girth does not go with the other measurements" in body.warnings[0]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_average", "male_average", "female_heavy", "female_old"])
def test_forty_measurements_of_samples_are_reproduced(name: str) -> None:
    """A sample's atlas is not on the bodies' map, so that its landmarks are elsewhere by 2 mm."""
    chart = bm.measure_chart(bm.load_sample(name))
    keys = [key for key in [*FOURTEEN, *WOMAN] if key != "stature"]
    wanted = {key: chart[key].value for key in dict.fromkeys(keys)}
    body = bm.make_body(wanted, unit="m")
    again = bm.measure_chart(body.atlas, only=list(wanted))
    for key, value in wanted.items():
        assert again[key].value == pytest.approx(value, abs=1e-4), key


def test_the_atlas_is_that_of_the_vertices() -> None:
    body = _few()
    assert np.abs(coefficients_of(body.vertices) - body.coefficients).max() < 1e-8
    assert np.abs(atlas_of(body.coefficients).points - body.atlas.points).max() == 0.0
    assert body.atlas.given["stature"].value == pytest.approx(1.68, abs=2e-5)
    assert "3 measurements" in body.atlas.provenance["source"]


def test_an_angle_may_be_zero() -> None:
    values = {"shoulder_slope": "0 deg", "bust": "88 cm", "waist": "72 cm", "hip": "97 cm"}
    body = bm.make_body(values, despite_doubts=True)
    slope = body.asked[0]
    assert slope.value.key == "shoulder_slope_right"
    assert slope.found == pytest.approx(0.0, abs=0.02)
    assert slope.deviation < 0.1
