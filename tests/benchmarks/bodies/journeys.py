"""How many functions of the package a number passes through on three journeys.

Run it by hand: ``python tests/benchmarks/bodies/journeys.py [--functions]``.

For each journey it prints the number of distinct functions of the package that are called, the
greatest number of them that are open at once, and the number of files that they are in. Each
journey runs once before it is counted, so that imports and caches are left out. The script also
runs on earlier states of the package, whose names it tries in turn.
"""

import argparse
import importlib
import inspect
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any, NamedTuple

import msgspec
import numpy as np

import bodymeasure as bm

PACKAGE = str(Path(bm.__file__).parent)
# The homes of what is not public at the top of the package, the present one first.
CHART_REPORTS = ("bodymeasure.report.body", "bodymeasure.report.measurements")
# The length of both shoulders; rules of the set derive landmarks that the body lacks.
DEFINITION = "shoulder_length_{side}"


class Count(NamedTuple):
    """What a journey goes through: functions by file and name, and how deep they are nested."""

    functions: set[tuple[str, str]]
    depth: int


def count(journey: Callable[[], object]) -> Count:
    """Follow the calls of a journey. Comprehensions and lambdas belong to their functions."""
    functions: set[tuple[str, str]] = set()
    depth = deepest = 0

    def follow(frame: FrameType, event: str, _: object) -> None:
        nonlocal depth, deepest
        code = frame.f_code
        if not code.co_filename.startswith(PACKAGE) or code.co_name.startswith("<"):
            return
        if event == "call":
            functions.add((code.co_filename[len(PACKAGE) + 1 :], code.co_qualname))
            depth += 1
            deepest = max(deepest, depth)
        elif event == "return":
            depth -= 1

    journey()
    sys.setprofile(follow)
    try:
        journey()
    finally:
        sys.setprofile(None)
    return Count(functions, deepest)


def control_points_to_row() -> bytes:
    """The lengths of one patch, given by its control points, as rows of the report's CSV file."""
    report = importlib.import_module("bodymeasure.report")
    steps = np.linspace(0.0, 9.0, 4)
    x, y = np.meshgrid(steps, steps, indexing="ij")
    points = np.stack([x, y, np.sin(x) + np.cos(y)], axis=-1)
    atlas = bm.Atlas(points.reshape(-1, 3), np.arange(16).reshape(1, 4, 4), bm.Unit.CM)
    survey = bm.Survey(atlas, bm.diagonals(atlas), bm.boundary_lengths(atlas))
    document = report.survey_document(survey, "cm")
    return _rows(report.to_csv, document)


def points_to_length(body: bm.Atlas) -> float:
    """The length of the geodesic between two landmarks."""
    start, end = (body.landmarks[name] for name in ("back neck point", "side waist point left"))
    return float(bm.geodesic_between(body, start, end).length)


def definition_to_cell(body: bm.Atlas) -> bytes:
    """One measurement of the default set, as a row of the chart's CSV file."""
    report = next(filter(None, map(_imported, CHART_REPORTS)))
    definitions = bm.load_definitions()
    (one,) = (each for each in definitions.measurement if each.key == DEFINITION)
    chart = bm.measure_chart(body, msgspec.structs.replace(definitions, measurement=(one,)))
    document = report.chart_document(chart, "cm")
    return _rows(report.chart_to_csv, document)


def _rows(to_csv: Callable[..., bytes], document: Any) -> bytes:
    """Call a writer of CSV that takes a document or, in earlier states, its measurements."""
    (parameter,) = inspect.signature(to_csv).parameters
    return to_csv(document if parameter == "document" else document.measurements)


def _imported(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError:
        return None


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--functions", action="store_true", help="list the functions, too")
    options = parser.parse_args()
    body = bm.load_sample("female_average")
    journeys: dict[str, Callable[[], object]] = {
        "control points to a row of the report": control_points_to_row,
        "two points to a length": lambda: points_to_length(body),
        "a definition to a cell of the chart": lambda: definition_to_cell(body),
    }
    for name, journey in journeys.items():
        found = count(journey)
        files = {file for file, _ in found.functions}
        print(
            f"{name}: {len(found.functions)} functions, {found.depth} deep, in {len(files)} files"
        )
        if options.functions:
            for file, function in sorted(found.functions):
                print(f"    {file}: {function}")


if __name__ == "__main__":
    main()
