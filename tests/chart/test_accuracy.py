import pytest

from bodymeasure.chart import AccuracyClass, MeasurementDefinition, both_sides, load_definitions
from bodymeasure.chart.kinds import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    DepthMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthArcMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    PathMeasure,
)


@pytest.mark.parametrize(
    ("definition", "expected"),
    [
        (HeightMeasure(key="a", name="Waist height", at="w"), "height"),
        (HeightMeasure(key="a", name="Body rise", at="w", above="c"), "segment length"),
        (BreadthMeasure(key="a", name="Hip breadth", at="h"), "breadth"),
        (ChordMeasure(key="a", name="Shoulder breadth", start="l", end="r"), "breadth"),
        (ChordMeasure(key="a", name="Neck width", start="l", end="r"), "segment length"),
        (DepthMeasure(key="a", name="Bust depth", at="b"), "depth"),
        (GirthMeasure(key="a", name="Bust girth", at="b"), "large girth"),
        (GirthMeasure(key="a", name="Neck girth", at="n"), "small girth"),
        (GirthMeasure(key="a", name="Thigh girth, left", at="t"), "small girth"),
        (GirthMeasure(key="a", name="Calf girth", at="c"), "small girth"),
        (ClosedMeasure(key="a", name="Natural waist girth", at="w"), "large girth"),
        (
            GirthArcMeasure(
                key="a", name="Front of the girth", at="b", start="l", end="r", side="front"
            ),
            "segment length",
        ),
        (LimbGirthMeasure(key="a", name="Upper arm", start="s", end="e"), "small girth"),
        (
            ExtremeGirthMeasure(
                key="a", name="Widest", start="k", end="f", extreme="largest", limb=True
            ),
            "small girth",
        ),
        (PathMeasure(key="a", name="Neck base girth", through=("a", "b")), "small girth"),
        (PathMeasure(key="a", name="Trunk girth", through=("a", "b")), "large girth"),
        (PathMeasure(key="a", name="Upper arm length", through=("a", "b")), "segment length"),
        (FormulaMeasure(key="a", name="Outer arm length", formula="1"), "segment length"),
        (FormulaMeasure(key="a", name="Slope", formula="1", angle=True), None),
    ],
)
def test_the_class_follows_from_kind_and_name(
    definition: MeasurementDefinition, expected: str | None
) -> None:
    assert definition.accuracy_class == expected


def test_the_classes_allow_what_the_standard_does() -> None:
    allowed = {each.value: each.maximum_error_mm for each in AccuracyClass}
    assert allowed == {
        "height": 4.0,
        "small girth": 4.0,
        "breadth": 4.0,
        "segment length": 5.0,
        "depth": 5.0,
        "large girth": 9.0,
    }


def test_every_default_measurement_but_the_angles_has_a_class() -> None:
    classes = {one.key: one.accuracy_class for one in both_sides(load_definitions().measurement)}
    without = {key for key, found in classes.items() if found is None}
    assert without
    assert all("slope" in key or "angle" in key for key in without)
    assert classes["bust_girth"] == AccuracyClass.LARGE_GIRTH
    assert classes["neck_girth"] == AccuracyClass.SMALL_GIRTH
    assert classes["upper_arm_girth_left"] == AccuracyClass.SMALL_GIRTH
    assert set(classes.values()) >= set(AccuracyClass)
