"""Percentiles, correlations, outliers and nearest bodies, against SciPy and closed forms."""

import numpy as np
import pytest
import scipy
from helpers.speed import quick

from bodymeasure.errors import InputError
from bodymeasure.surveys.statistics import (
    correlations,
    main_keys,
    nearest_bodies,
    outliers,
    percentile_interval,
    summary,
)
from bodymeasure.surveys.statistics.outliers import FAR, deviations


@pytest.mark.parametrize("count", quick([200, 8, 31, 5000], first=2))
@pytest.mark.parametrize("part", [0.01, 0.05, 0.5, 0.95])
def test_intervals_of_percentiles_are_those_of_scipy(
    count: int, part: float, rng: np.random.Generator
) -> None:
    values = np.sort(rng.normal(170.0, 7.0, count))
    wanted = scipy.stats.quantile_test(values, p=part).confidence_interval(0.95)
    found = percentile_interval(values, part)
    for end, want in zip(found, wanted, strict=True):
        assert (end is None) if np.isnan(want) else (end == want)


def test_intervals_hold_as_much_as_the_binomial_distribution_says() -> None:
    # Between the j-th and the k-th of n lies a quantile with the probability of j to k - 1 below.
    count, part = 100, 0.25
    low, high = percentile_interval(np.arange(count, dtype=float), part)
    assert low is not None
    assert high is not None
    below = scipy.stats.binom(count, part)
    assert below.cdf(high) - below.cdf(low) >= 0.95
    assert below.cdf(low) <= 0.025
    assert 1.0 - below.cdf(high) <= 0.025


def test_a_summary_leaves_out_what_has_no_value(rng: np.random.Generator) -> None:
    values = rng.normal(90.0, 5.0, 300)
    with_gaps = np.insert(values, [3, 50], np.nan)
    found = summary(with_gaps)
    assert found.count == 300
    assert found.mean == pytest.approx(np.mean(values), rel=1e-14)
    assert found.deviation == pytest.approx(np.std(values, ddof=1), rel=1e-12)
    assert (found.minimum, found.maximum) == (values.min(), values.max())
    quantiles = [one.value for one in found.percentiles]
    wanted = np.percentile(values, [one.percent for one in found.percentiles])
    assert quantiles == pytest.approx(wanted, rel=1e-14)


def test_summaries_of_few_bodies_say_what_they_cannot() -> None:
    assert summary(np.array([np.nan])).percentiles == ()
    one = summary(np.array([3.0]))
    assert (one.count, one.mean, one.deviation) == (1, 3.0, None)
    median = next(each for each in one.percentiles if each.percent == 50.0)
    assert (median.value, median.low, median.high) == (3.0, None, None)


def test_correlations_are_those_of_the_bodies_that_have_both(rng: np.random.Generator) -> None:
    values = 100.0 + rng.normal(size=(60, 4)) @ rng.normal(size=(4, 4))
    values[rng.random(values.shape) < 0.2] = np.nan
    found = correlations(values)
    for i in range(4):
        for j in range(4):
            both = np.isfinite(values[:, i]) & np.isfinite(values[:, j])
            wanted = scipy.stats.pearsonr(values[both, i], values[both, j]).statistic
            assert found[i, j] == pytest.approx(wanted, abs=1e-12)


def test_correlations_that_there_are_not_are_none(rng: np.random.Generator) -> None:
    values = np.column_stack([rng.normal(size=9), np.full(9, 71.3), np.full(9, np.nan)])
    found = correlations(values)
    assert found[0, 0] == 1.0
    assert np.isnan(found[1:]).all()
    assert np.isnan(found[:, 1:]).all()


def test_outliers_do_not_hide_themselves(rng: np.random.Generator) -> None:
    values = rng.normal(90.0, 5.0, (500, 3)).clip(75.0, 105.0)
    values[7] = 60.0, 90.0, 190.0
    values[9, 1] = 140.0
    values[11, 0] = np.nan
    found = outliers(values)
    assert [(each.body, each.column, each.others) for each in found] == [(7, 2, 1), (9, 1, 0)]
    assert found[0].value == 190.0
    assert found[0].deviations == pytest.approx(20.0, rel=0.2)
    assert found[1].deviations >= FAR


def test_deviations_are_in_the_standard_deviation_of_normal_values(
    rng: np.random.Generator,
) -> None:
    values = rng.normal(3.0, 2.0, 200_000)
    assert deviations(values).std() == pytest.approx(1.0, abs=0.01)
    # Too few values, or more than half of them the same, tell nothing.
    assert deviations(np.array([1.0, 5.0, np.nan])).tolist()[:2] == [0.0, 0.0]
    assert not deviations(np.array([1.0] * 9 + [50.0])).any()


def test_the_nearest_bodies_are_so_in_standard_deviations(rng: np.random.Generator) -> None:
    values = {"a": rng.normal(170.0, 10.0, 50), "b": rng.normal(70.0, 1.0, 50)}
    values["a"][4] = np.nan
    size = {"a": 172.0, "b": 70.5}
    found = nearest_bodies(values, size, count=3)
    spread = [np.nanstd(values[key], ddof=1) for key in size]
    spread[1] = np.delete(values["b"], 4).std(ddof=1)
    parts = [
        ((values[key] - size[key]) / each) ** 2 for key, each in zip(size, spread, strict=True)
    ]
    distance = np.sqrt(np.mean(parts, axis=0))
    assert [each.body for each in found] == np.argsort(distance)[:3].tolist()
    assert found[0].distance == pytest.approx(np.nanmin(distance), rel=1e-12)
    assert found[0].differences[0] == values["a"][found[0].body] - 172.0
    assert nearest_bodies({"a": np.full(3, np.nan)}, {"a": 1.0}) == ()
    with pytest.raises(InputError, match="the size has no measurement"):
        nearest_bodies(values, {})


def test_the_main_measurements_are_taken_where_they_are_there() -> None:
    assert main_keys(["x", "hip_girth", "stature", "y"]) == ("stature", "hip_girth")
    assert main_keys(["x", "y", "z"], count=2) == ("x", "y")
