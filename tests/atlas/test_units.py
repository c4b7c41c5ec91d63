import numpy as np
import pytest

from bodymeasure import InputError, Unit
from bodymeasure.atlas import convert_length


@pytest.mark.parametrize(
    ("length", "source", "target", "expected"),
    [
        (1.0, Unit.INCH, Unit.CM, 2.54),
        (1.0, Unit.M, Unit.MM, 1000.0),
        (25.4, Unit.MM, Unit.INCH, 1.0),
        (160.5, Unit.CM, Unit.M, 1.605),
    ],
)
def test_lengths_convert(length: float, source: Unit, target: Unit, expected: float) -> None:
    assert convert_length(length, source, target) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("source", Unit)
@pytest.mark.parametrize("target", Unit)
def test_arrays_convert_there_and_back(source: Unit, target: Unit) -> None:
    lengths = np.array([0.1, 7.0, np.nan])
    back = convert_length(convert_length(lengths, source, target), target, source)
    np.testing.assert_allclose(back, lengths, rtol=1e-15)


def test_a_length_in_its_own_unit_is_the_same_to_the_last_bit() -> None:
    assert convert_length(0.1, Unit.INCH, Unit.INCH) == 0.1


@pytest.mark.parametrize("text", ["km", "", "CM", "inches"])
def test_units_are_never_guessed(text: str) -> None:
    with pytest.raises(InputError, match=f"unknown unit '{text}'; expected one of m, cm, mm, inch"):
        Unit.parse(text)
