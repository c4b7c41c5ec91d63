"""`bodymeasure bench` with few problems."""

from pathlib import Path

import msgspec
import pytest
from helpers.charts.small_benchmark import SMALL, small_benchmark
from helpers.command_line import Run, hide_here, run_apart

import bodymeasure.bench
from bodymeasure.bench import BenchDocument, Size

WITHOUT = "pygeodesic is not installed, and takes no part.\n"


@pytest.fixture(autouse=True)
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the command run a small benchmark, once for all tests; the real one is slow."""

    def run(size: Size, *, progress: object) -> BenchDocument:
        assert size is SMALL
        assert callable(progress)
        document = small_benchmark()
        # pygeodesic counts as installed, since only one test is about its absence.
        versions = {"pygeodesic": "0.1", **document.versions}
        return msgspec.structs.replace(document, versions=versions)

    monkeypatch.setattr(bodymeasure.bench, "QUICK", SMALL)
    monkeypatch.setattr(bodymeasure.bench, "run_benchmark", run)


@pytest.mark.slow
def test_all_is_printed_and_nothing_written(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = run("bench", "--quick")
    assert (ran.code, ran.err) == (0, "")
    document = small_benchmark()
    for result in document.results:
        assert f"{result.method}, {result.setting}".removesuffix(", ") in ran.out
    for record in document.sets:
        assert f"{record.title}: {record.compared} of {record.drawn} {record.noun}" in ran.out
    for figure in document.figures:
        assert figure.name in ran.out
    assert "1,000" in ran.out
    assert "Newton's method" in ran.out
    assert "held to 1" in ran.out
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_failures_and_problems_left_out_are_told(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    document = small_benchmark()
    sets = [
        msgspec.structs.replace(record, drawn=99, leaving_patch=7, unresolved_truth=8)
        for record in document.sets
    ]
    results = [
        msgspec.structs.replace(
            result,
            failures=result.problems,
            error_tenth=None,
            error_median=None,
            error_ninetieth=None,
            error_worst=None,
        )
        for result in document.results
    ]
    versions = {"pygeodesic": "0.1", **document.versions}
    other = msgspec.structs.replace(document, versions=versions, sets=sets, results=results)
    monkeypatch.setattr(bodymeasure.bench, "run_benchmark", lambda *_args, **_options: other)
    ran = run("bench", "--quick")
    assert (ran.code, ran.err) == (0, "")
    assert "left out: 7 leave their patch, 8 without a true length" in ran.out
    (line,) = [line for line in ran.out.splitlines() if line.startswith("shooting")][:1]
    assert line.split()[1:3] == ["1", "1"]


@pytest.mark.slow
def test_the_real_thing(tmp_path: Path) -> None:
    ran = run_apart("bench", "--quick", "-o", tmp_path / "out")
    assert ran.code == 0
    assert ran.err in ("", WITHOUT)
    assert len(list((tmp_path / "out").iterdir())) == 4
    assert "1,000" in ran.out


@pytest.mark.slow
def test_files_are_named_and_written(run: Run, tmp_path: Path) -> None:
    ran = run("bench", "--quick", "-o", tmp_path / "out")
    assert (ran.code, ran.err) == (0, "")
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == ["bench.csv", "bench.json", "bodies.svg", "error_against_time.svg"]
    for name in names:
        assert str(tmp_path / "out" / name) in ran.out


def test_a_folder_that_cannot_be_is_told_before_any_work(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(bodymeasure.bench, "run_benchmark")
    (tmp_path / "file").write_text("")
    ran = run("bench", "--quick", "-o", tmp_path / "file")
    assert (ran.code, ran.out) == (2, "")
    assert "file: cannot be written (it is a file, not a folder)" in ran.err


@pytest.mark.parametrize(
    ("hidden", "package", "arguments"),
    [
        ("igl", "libigl", ()),
        ("potpourri3d", "potpourri3d", ()),
        ("trimesh", "trimesh", ()),
        ("matplotlib", "matplotlib", ("-o", "out")),
    ],
)
def test_a_missing_package_is_told(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    hidden: str,
    package: str,
    arguments: tuple[str, ...],
) -> None:
    monkeypatch.chdir(tmp_path)
    hide_here(monkeypatch, hidden)
    ran = run("bench", "--quick", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert f"needs the package {package!r}, which is not installed" in ran.err
    assert ran.err.endswith("pip install 'bodymeasure[bench]'\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_that_a_library_takes_no_part_is_told(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    document = small_benchmark()
    versions = {name: each for name, each in document.versions.items() if name != "pygeodesic"}
    without = msgspec.structs.replace(document, versions=versions)
    monkeypatch.setattr(bodymeasure.bench, "run_benchmark", lambda *_args, **_options: without)
    ran = run("bench", "--quick")
    assert (ran.code, ran.err) == (0, WITHOUT)


@pytest.mark.slow
def test_matplotlib_is_needed_for_the_picture_alone(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    small_benchmark()
    hide_here(monkeypatch, "matplotlib")
    assert run("bench", "--quick").code == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--fast",), "No such option"),
        (("enneper",), "unexpected extra argument"),
        (("-o",), "requires an argument"),
    ],
)
def test_wrong_usage_is_told(run: Run, arguments: tuple[str, ...], message: str) -> None:
    ran = run("bench", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
