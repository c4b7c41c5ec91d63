"""What pages in one file cost: their size, the time to make them, and the time to a first picture.

    python tests/benchmarks/viewer/exported.py

Times are processor time, so that other work on the machine counts little. Pages of charts and
reports with a scene and without one are made in turns; how many times as long they take is what
counts.
"""

import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import psutil
from bodymeasure.viewer import export_page
from playwright.sync_api import sync_playwright

import bodymeasure as bm
from bodymeasure.report import write_chart, write_report

TURNS = 3
ARGUMENTS = (
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
)
PATIENCE = 60_000


def timed(make: Callable[[], Path]) -> tuple[float, int]:
    """Return the processor time of making a page, and its size."""
    start = time.process_time()
    path = make()
    return time.process_time() - start, path.stat().st_size


def in_turns(name: str, ways: dict[str, Callable[[], Path]]) -> None:
    """Print what several ways of making a page take, made one after the other in each turn."""
    found = [{way: timed(make) for way, make in ways.items()} for _ in range(TURNS)]
    for way in ways:
        seconds = np.median([turn[way][0] for turn in found])
        print(f"{name}, {way}: {seconds:.1f} s, {found[0][way][1] / 1e6:.2f} MB")


def browser_time() -> float:
    """Return the processor time of the browsers that this process started."""
    total = 0.0
    for process in psutil.Process().children(recursive=True):
        try:
            if "chrom" in process.name():
                total += sum(process.cpu_times()[:2])
        except psutil.NoSuchProcess:
            pass
    return total


def first_picture(paths: dict[str, Path]) -> None:
    """Print the browser's time from opening a file to its first picture, without a network."""
    program = shutil.which("chromium")
    assert program is not None, "there is no Chromium here"
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=list(ARGUMENTS))
        for name, path in paths.items():
            times = []
            for _ in range(TURNS):
                page = browser.new_context(offline=True).new_page()
                page.goto("about:blank")
                start = browser_time()
                page.goto(path.as_uri())
                page.wait_for_selector("#bodymeasure[data-ready]", timeout=PATIENCE)
                times.append(browser_time() - start)
                page.context.close()
            print(f"first picture of {name}: {np.median(times):.2f} s")
        browser.close()


def main() -> None:
    """Measure a sample, and print what its pages cost."""
    body = bm.load_sample("female_average")
    chart, survey = bm.measure_chart(body), bm.measure_atlas(body)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        paths = {}
        for name, shown in {"the body": body, "the chart": chart, "the survey": survey}.items():
            paths[name] = folder / f"{name}.html"
            seconds, size = timed(lambda: _written(shown, paths[name]))  # noqa: B023
            print(f"page of {name}: {seconds:.1f} s, {size / 1e6:.2f} MB")
        in_turns(
            "chart.html",
            {
                "with a scene": lambda: write_chart(chart, folder, scene=export_page(chart))[0],
                "without": lambda: write_chart(chart, folder)[0],
            },
        )
        in_turns(
            "report.html",
            {
                "with a scene": lambda: write_report(survey, folder, scene=export_page(survey))[0],
                "without": lambda: write_report(survey, folder)[0],
            },
        )
        first_picture(paths)


def _written(shown: object, path: Path) -> Path:
    export_page(shown, path)
    return path


if __name__ == "__main__":
    main()
