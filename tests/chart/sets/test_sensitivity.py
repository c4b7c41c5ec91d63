"""What values owe to the places of landmarks."""

import pytest
from helpers.charts.posts import post

from bodymeasure.chart import Definitions, measure_chart
from bodymeasure.chart.kinds import ChordMeasure, FormulaMeasure, HeightMeasure


def test_formulas_owe_what_their_operands_do_each_of_which_is_measured_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    begun: list[str] = []
    measure = HeightMeasure.measure

    def noted(self: HeightMeasure, *others: object) -> object:
        begun.append(self.key)
        return measure(self, *others)  # type: ignore[arg-type]

    monkeypatch.setattr(HeightMeasure, "measure", noted)
    measurements = (
        HeightMeasure(key="high", name="high", at="high front"),
        HeightMeasure(key="low", name="low", at="low left"),
        ChordMeasure(key="across", name="across", start="high front", end="high back"),
        FormulaMeasure(key="first", name="first", formula="high + 2 * low"),
        FormulaMeasure(key="second", name="second", formula="high - low + across"),
    )
    chart = measure_chart(
        post(), Definitions(name="Test", measurement=measurements), sensitivity=True
    )
    shifts = {
        (item.definition.key, shift.landmark): shift
        for item in chart.measured
        for shift in item.shifts
    }
    # The post is upright and in centimeters, so that 5 mm along it are half of one.
    assert shifts["high", "high front"].up == pytest.approx(0.5, abs=1e-12)
    assert shifts["first", "low left"].up == pytest.approx(1.0, abs=1e-12)
    assert shifts["second", "low left"].up == pytest.approx(-0.5, abs=1e-12)
    chord = shifts["across", "high front"]
    assert shifts["second", "high front"].up == pytest.approx(0.5 + chord.up, abs=1e-12)
    assert shifts["second", "high front"].across == pytest.approx(chord.across, abs=1e-12)
    # On the body itself, with its landmark higher, and with that to the side.
    assert sorted(begun) == ["high"] * 3 + ["low"] * 3
