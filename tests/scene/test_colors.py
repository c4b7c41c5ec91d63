import numpy as np
import pytest
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas
from bodymeasure.scene import ColorScale, body_scene


@pytest.mark.parametrize(
    ("difference", "low", "high"),
    [
        ([2e-7, 3e-5], 1e-7, 1e-4),
        ([1e-6, 1e-5], 1e-6, 1e-5),  # powers of ten open no decade of their own
        ([1e-6, 1e-6], 1e-7, 1e-6),  # never empty
        ([0.0, 0.0], 1e-13, 1e-12),
        ([1e-11, 0.5], 1e-8, 1.0),  # at most eight decades
    ],
)
def test_the_scale_spans_whole_decades(
    square: Atlas, difference: list[float], low: float, high: float
) -> None:
    paths = body_scene(straight_survey(square, difference=np.array([difference]))).paths
    scale = ColorScale.of(paths)
    assert scale is not None
    np.testing.assert_allclose([scale.low, scale.high], [low, high], rtol=1e-12)


def test_larger_differences_are_darker_throughout() -> None:
    brightness = ColorScale(1e-9, 1e-3).rgb(np.logspace(-9, -3, 40)) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(brightness) < 0.0).all()


def test_beyond_its_ends_the_scale_keeps_the_last_colors() -> None:
    scale = ColorScale(1e-8, 1e-4)
    np.testing.assert_array_equal(
        scale.rgb(np.array([0.0, 1e-12, 1.0])), scale.rgb(np.array([1e-8, 1e-8, 1e-4]))
    )


def test_without_comparisons_there_is_no_scale(square: Atlas) -> None:
    assert ColorScale.of(body_scene(straight_survey(square, check=False)).paths) is None
