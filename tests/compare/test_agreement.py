"""Limits of agreement and intra-class correlation, against SciPy, closed forms and tables."""

import json
from pathlib import Path

import numpy as np
import pytest
import scipy
from helpers.command_line import run_here
from helpers.populations import knees, write_shapes

import bodymeasure as bm
from bodymeasure.compare import Known, Reading, Readings, compare, render_comparison
from bodymeasure.compare.intraclass import Intraclass, intraclass
from bodymeasure.compare.limits import limits_of_agreement
from bodymeasure.compare.plots import MOST, plot_of
from bodymeasure.compare.shown import icc, limits

# Ratings of six subjects by four judges, of P. E. Shrout and J. L. Fleiss, 1979, table 2.
JUDGES = np.array(
    [[9, 2, 5, 8], [6, 1, 3, 2], [8, 4, 6, 8], [7, 1, 2, 6], [10, 5, 6, 9], [6, 2, 4, 7]],
    dtype=float,
)


def test_limits_are_those_of_the_normal_distribution(rng: np.random.Generator) -> None:
    differences = rng.normal(0.3, 0.8, 50)
    found = limits_of_agreement(differences.tolist())
    assert found is not None
    wanted = scipy.stats.norm.interval(0.95, differences.mean(), differences.std(ddof=1))
    assert (found.lower, found.upper) == pytest.approx(wanted, rel=1e-12)
    z = scipy.stats.norm.ppf(0.975)
    error = differences.std(ddof=1) * np.sqrt(1.0 / 50.0 + z**2 / 98.0)
    ends = scipy.stats.t.interval(0.95, 49, found.lower, error)
    half = found.half_width
    assert (found.lower - half, found.lower + half) == pytest.approx(ends, rel=1e-12)
    assert limits_of_agreement([0.3]) is None


def test_intervals_of_limits_hold_the_true_limit(rng: np.random.Generator) -> None:
    held = 0
    for _ in range(2000):
        found = limits_of_agreement(rng.normal(1.0, 2.0, 40).tolist())
        assert found is not None
        held += abs(found.upper - (1.0 + 1.959964 * 2.0)) <= found.half_width
    assert held / 2000 == pytest.approx(0.95, abs=0.015)


def test_the_judges_of_shrout_and_fleiss_agree_as_they_say() -> None:
    found = intraclass(JUDGES)
    assert found is not None
    assert round(found.agreement, 2) == 0.29
    assert round(found.consistency, 2) == 0.71
    # The interval of McGraw and Wong for these data, as R's package psych prints it.
    assert found.low == pytest.approx(0.019, abs=5e-4)
    assert found.high == pytest.approx(0.761, abs=5e-4)


def by_definition(values: np.ndarray) -> tuple[float, float, float, float]:
    """The coefficients by least squares with indicator columns, and SciPy's F distribution."""
    n, k = values.shape
    ones = np.ones((n, k))
    subjects = np.stack([np.where(np.arange(n)[:, None] == i, ones, 0.0).ravel() for i in range(n)])
    methods = np.stack([np.where(np.arange(k) == j, ones, 0.0).ravel() for j in range(k)])
    y = values.ravel()

    def left(columns: np.ndarray) -> float:
        solved, *_ = np.linalg.lstsq(columns.T, y, rcond=None)
        return float(((y - columns.T @ solved) ** 2).sum())

    both = left(np.concatenate([subjects, methods]))
    msr = (left(methods) - both) / (n - 1)
    msc = (left(subjects) - both) / (k - 1)
    mse = both / ((n - 1) * (k - 1))
    r = (msr - mse) / (msr + (k - 1) * mse + k * (msc - mse) / n)
    a, b = k * r / (n * (1 - r)), 1 + k * r * (n - 1) / (n * (1 - r))
    v = (a * msc + b * mse) ** 2 / ((a * msc) ** 2 / (k - 1) + (b * mse) ** 2 / ((n - 1) * (k - 1)))
    f = scipy.stats.f.ppf(0.975, n - 1, v)
    low = n * (msr - f * mse) / (f * (k * msc + (k * n - k - n) * mse) + n * msr)
    f = scipy.stats.f.ppf(0.975, v, n - 1)
    high = n * (f * msr - mse) / (k * msc + (k * n - k - n) * mse + n * f * msr)
    return r, low, high, (msr - mse) / (msr + (k - 1) * mse)


@pytest.mark.parametrize(("methods", "bias"), [(2, 0.0), (2, 3.0), (4, 1.0)])
def test_the_correlation_is_that_of_a_two_way_model(
    methods: int, bias: float, rng: np.random.Generator
) -> None:
    values = rng.normal(0.0, 5.0, (30, 1)) + rng.normal(0.0, 1.0, (30, methods))
    values[:, 0] += bias
    found = intraclass(values)
    assert found is not None
    wanted = by_definition(values)
    assert (found.agreement, found.low, found.high, found.consistency) == pytest.approx(
        wanted, rel=1e-12
    )


def test_correlations_at_the_ends() -> None:
    same = np.array([[1.0, 1.0], [2.0, 2.0], [4.0, 4.0]])
    assert intraclass(same) == Intraclass(1.0, None, None, 1.0)
    shifted = intraclass(same + np.array([0.0, 1.0]))
    assert shifted is not None
    assert shifted.consistency == pytest.approx(1.0, abs=1e-12)
    assert shifted.agreement < 0.9
    assert intraclass(same[:2]) is None
    assert intraclass(np.full((5, 2), 71.3)) is None
    assert intraclass(np.full((5, 2), 71.3) + np.array([0.0, 0.4])) is None


def readings(name: str, values: list[float]) -> Readings:
    known = (Known("waist_girth", "Waist <girth>", "large girth"),)
    rows = [Reading(f"<b>{n}", "waist_girth", value, "cm") for n, value in enumerate(values)]
    return Readings(name, tuple(rows), known)


def test_a_comparison_has_limits_correlation_and_plots(rng: np.random.Generator) -> None:
    a = rng.normal(75.0, 6.0, 60)
    b = a + rng.normal(0.4, 0.5, 60)
    comparison = compare(readings("one", a.tolist()), readings("other", b.tolist()))
    (agreement,) = comparison.agreements
    found, wanted = limits_of_agreement((a - b).tolist()), intraclass(np.column_stack([a, b]))
    assert found is not None
    assert wanted is not None
    assert (agreement.lower_limit, agreement.upper_limit) == pytest.approx(found[:2], rel=1e-12)
    assert (agreement.icc, agreement.icc_consistency) == pytest.approx(
        (wanted.agreement, wanted.consistency), rel=1e-12
    )
    assert icc(agreement) == "0.993"
    assert " to " in limits(agreement).replace("\N{NO-BREAK SPACE}", " ")
    page = render_comparison(comparison).decode()
    assert "Bland-Altman plots" in page
    assert page.count("<circle") == 60
    assert "<title>&lt;b&gt;3</title>" in page
    plot = plot_of(agreement, comparison.differences)
    assert plot is not None
    # Larger differences stand higher, larger means farther right.
    by_difference = np.argsort(a - b)
    heights = np.array([point[1] for point in plot.points])
    assert (np.diff(heights[by_difference]) <= 0.01).all()
    places = np.array([point[0] for point in plot.points])
    assert (np.diff(places[np.argsort(a + b)]) >= -0.01).all()
    kinds = [line.kind for line in plot.lines]
    assert kinds[:4] == ["zero", "mean", "limit", "limit"]
    mean, lower, upper = (line.y for line in plot.lines[1:4])
    assert upper < mean < lower
    # One subject has neither.
    single = compare(readings("one", [70.0]), readings("other", [71.0]))
    assert "Bland-Altman" not in render_comparison(single).decode()
    assert single.agreements[0].icc is None


def test_of_many_subjects_some_are_drawn_and_all_that_stand_out(rng: np.random.Generator) -> None:
    a = rng.normal(75.0, 6.0, 4 * MOST)
    b = a + rng.normal(0.0, 0.5, len(a))
    b[7] += 9.0
    comparison = compare(readings("one", a.tolist()), readings("other", b.tolist()))
    plot = plot_of(comparison.agreements[0], comparison.differences)
    assert plot is not None
    assert MOST <= plot.drawn < 1.5 * MOST
    assert "<b>7" in {subject for _, _, subject in plot.points}


@pytest.mark.slow
def test_two_surveys_are_compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pyarrow")
    path = write_shapes(tmp_path / "many.npz", 5, names=np.array(list("pqrst")))
    one = bm.survey(path, folder=tmp_path / "one", only=["knee_height"])
    names = ["subject,measurement,value,unit"]
    for subject, value in zip(one.subjects, one["knee_height_left"].tolist(), strict=True):
        names.append(f"{subject},knee_height_left,{value + 0.5!r},cm")
    (tmp_path / "hand.csv").write_text("\n".join(names), encoding="utf-8")
    out = tmp_path / "out.json"
    ran = run_here(capsys, "compare", tmp_path / "one", tmp_path / "hand.csv", "-o", out)
    assert ran.code == 0
    assert "ICC" in ran.out
    (agreement,) = json.loads(out.read_text(encoding="utf-8"))["agreements"]
    assert agreement["mean"] == pytest.approx(-0.5, abs=1e-12)
    assert agreement["icc_consistency"] == pytest.approx(1.0, abs=1e-12)
    bm.survey(path, folder=tmp_path / "two", only=["knee_height"], unit="inch")
    ran = run_here(capsys, "compare", tmp_path / "one", tmp_path / "two" / "survey.parquet")
    assert ran.code == 0
    assert "0.00" in ran.out
    # What a body lacks is noted with the reason.
    bm.survey(path, knees(), folder=tmp_path / "lacking")
    hand = "subject,measurement,value,unit\np,tail,80,cm\np,knee,46,cm\n"
    (tmp_path / "tails.csv").write_text(hand, encoding="utf-8")
    ran = run_here(capsys, "compare", tmp_path / "lacking", tmp_path / "tails.csv")
    assert "no value in survey.parquet: tail (the atlas has no landmark 'tail'" in ran.err
    wrong = run_here(capsys, "compare", tmp_path / "hand.csv", tmp_path / "broken.parquet")
    assert (wrong.code, "no such file" in wrong.err) == (2, True)
