"""The numbers and files of a small benchmark."""

import csv
import io
import json
import math
import xml.etree.ElementTree as ET
from collections import Counter
from pathlib import Path
from typing import Any

import msgspec
import pytest
from helpers.charts.small_benchmark import PROGRESS, SMALL, small_benchmark

from bodymeasure.bench import (
    BenchDocument,
    benchmark_steps,
    error_against_time,
    to_csv,
    write_benchmark,
)
from bodymeasure.bench.bodies.kinds import KINDS
from bodymeasure.bench.bodies.sets import OURS, body_entrants
from bodymeasure.bench.entrants.entrants import DEFAULT, entrants
from bodymeasure.bench.figure import On, draw
from bodymeasure.bench.records import Result
from bodymeasure.errors import InputError
from bodymeasure.report.serial import indented_json
from bodymeasure.scene.figures.chart_style import chart_style


def refuse(constant: str) -> None:
    raise AssertionError(f"{constant} is no JSON")


def numbers(value: object) -> list[float]:
    """All numbers of a JSON value."""
    if isinstance(value, dict):
        return [number for each in value.values() for number in numbers(each)]
    if isinstance(value, list):
        return [number for each in value for number in numbers(each)]
    return [value] if isinstance(value, float) else []


@pytest.mark.slow
def test_json_holds_all_and_is_finite() -> None:
    document = small_benchmark()
    content = indented_json(document)
    found = numbers(json.loads(content, parse_constant=refuse))
    assert len(found) > 100
    assert all(map(math.isfinite, found))
    assert msgspec.json.decode(content, type=BenchDocument) == document


@pytest.mark.slow
def test_every_method_is_on_every_set() -> None:
    document = small_benchmark()
    on_patches = dict.fromkeys(("mild", "wild", "body"), len(entrants()))
    on_a_body = {kind.name: len(body_entrants(kind)) for kind in KINDS}
    assert [record.name for record in document.sets] == [*on_patches, *on_a_body]
    assert Counter(result.set for result in document.results) == on_patches | on_a_body
    for result in document.results:
        assert 0 <= result.failures <= result.problems
        assert 0.0 < result.time_lower_quartile <= result.time_median <= result.time_upper_quartile
        errors = (result.error_tenth, result.error_median, result.error_ninetieth)
        if result.failures < result.problems:
            known = [error for error in errors if error is not None]
            assert len(known) == 3
            assert known == sorted(known)
        if result.method in (DEFAULT, OURS):
            assert result.times_ours == 1.0


@pytest.mark.slow
def test_bodymeasure_is_right_on_every_set() -> None:
    ours = [result for result in small_benchmark().results if result.method == DEFAULT]
    assert len(ours) == 3
    for result in ours:
        assert result.failures == 0
        assert result.error_worst is not None
        assert result.error_worst < 1e-10


@pytest.mark.slow
def test_growth_threads_and_figures_are_told() -> None:
    document = small_benchmark()
    assert [record.patches for record in document.growth] == [10, 100, 1000]
    assert document.threads.limit == 1
    assert document.threads.others < 0.2
    assert set(document.versions) >= {"Python", "numpy", "scipy", "libigl", "potpourri3d"}
    for figure in document.figures:
        assert figure.value is not None, figure.name
        # Methods that do not converge have orders about 0.
        assert figure.value >= 0.0 or figure.name.endswith("order")


@pytest.mark.slow
def test_progress_ends_where_it_should() -> None:
    small_benchmark()
    assert list(range(1, benchmark_steps(SMALL) + 1)) == PROGRESS


@pytest.mark.slow
def test_csv_has_a_row_for_each_result() -> None:
    document = small_benchmark()
    rows = list(csv.DictReader(io.StringIO(to_csv(document).decode(), newline="")))
    assert len(rows) == len(document.results)
    for row, result in zip(rows, document.results, strict=True):
        assert row["method"] == result.method
        assert float(row["time_median"]) == result.time_median
        assert row["error_worst"] == ("" if result.error_worst is None else str(result.error_worst))


@pytest.mark.slow
def test_the_picture_names_all_methods_and_is_reproducible() -> None:
    document = small_benchmark()
    on_a_body = {entrant.method for kind in KINDS for entrant in body_entrants(kind)}
    methods = {entrant.method for entrant in entrants()}
    shown: tuple[tuple[On, set[str], slice], ...] = (
        ("patches", methods, slice(3)),
        ("body", on_a_body, slice(3, None)),
    )
    for on, names, sets in shown:
        picture = error_against_time(document, on=on)
        root = ET.fromstring(picture)
        assert root.tag == "{http://www.w3.org/2000/svg}svg"
        words = {text.text for text in root.iter("{http://www.w3.org/2000/svg}text")}
        assert words >= names
        assert words >= {record.title for record in document.sets[sets]}
        assert len(picture) < 150_000
        assert error_against_time(document, on=on) == picture


@pytest.mark.slow
def test_the_picture_shows_who_fails() -> None:
    document = small_benchmark()

    def failing(result: Result, failures: int) -> Result:
        # The method is neither the default one nor one whose other points would outweigh it.
        return msgspec.structs.replace(result, failures=failures)

    good = [failing(result, 0) for result in document.results]
    bad = [failing(r, r.problems - 1 if r.method == "Ritz" else 0) for r in document.results]
    pictures = [
        error_against_time(msgspec.structs.replace(document, results=results), on="patches")
        for results in (good, bad)
    ]
    hollow = [picture.count(b"fill: #ffffff; stroke: #3a9bd1") for picture in pictures]
    assert hollow[0] == 0
    assert hollow[1] > 0


@pytest.mark.slow
def test_a_method_without_any_length_can_be_drawn() -> None:
    document = small_benchmark()
    nothing = dict.fromkeys(("error_tenth", "error_median", "error_ninetieth", "error_worst"))
    results = [
        msgspec.structs.replace(result, failures=result.problems, **nothing)
        if result.method == "Ritz"
        else result
        for result in document.results
    ]
    picture = error_against_time(msgspec.structs.replace(document, results=results), on="patches")
    assert b"Ritz" in picture


@pytest.mark.slow
def test_files_are_written_together_or_not_at_all(tmp_path: Path) -> None:
    document = small_benchmark()
    files = write_benchmark(document, tmp_path / "new")
    assert sorted(path.name for path in files) == [
        "bench.csv",
        "bench.json",
        "bodies.svg",
        "error_against_time.svg",
    ]
    assert files[2].read_bytes() == indented_json(document)
    (tmp_path / "other" / "bench.csv").mkdir(parents=True)
    with pytest.raises(InputError, match=r"bench\.csv: cannot be written"):
        write_benchmark(document, tmp_path / "other")
    assert [path.name for path in (tmp_path / "other").iterdir()] == ["bench.csv"]


@pytest.mark.slow
@pytest.mark.parametrize("on", ["patches", "body"])
def test_the_keys_fit_into_the_picture(on: On) -> None:
    pytest.importorskip("matplotlib")
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    with chart_style("the figure", "bench"):
        figure = draw(small_benchmark(), on=on)
        canvas: Any = FigureCanvasAgg(figure)
        renderer = canvas.get_renderer()
        boxes = [legend.get_window_extent(renderer) for legend in figure.legends]
    assert len(boxes) == 2
    assert boxes[0].x1 < boxes[1].x0
    assert boxes[1].x1 <= figure.bbox.x1
