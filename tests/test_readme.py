"""README's examples are run as they stand there."""

import re
from pathlib import Path

import pytest

import bodymeasure as bm
from bodymeasure.cli.main import app

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, flags=re.MULTILINE | re.DOTALL)


def test_the_python_examples_run(capsys: pytest.CaptureFixture[str]) -> None:
    example, across, _ = blocks("python")
    code = [line for line in example.splitlines() if line and not line.startswith("import")]
    assert len(code) <= 10
    names: dict[str, object] = {}
    exec(example, names)
    lengths, sentence, error, oblique = capsys.readouterr().out.splitlines()
    assert lengths.endswith(" m")
    assert sentence == bm.Status.CONVERGED.sentence
    assert float(error) > 0.0
    assert re.fullmatch(r"0\.\d+ \+- \S+", oblique)
    pytest.importorskip("pygeodesic")
    exec(across, names)
    path, girth, tape, natural, ways = capsys.readouterr().out.splitlines()
    assert re.match(r"0\.\d+ \+- \S+ CONVERGED \(\d+, ", path)
    contact, taut, gap = map(float, girth.split())
    assert contact - taut == gap > 0.0
    chord, taut, contact = map(float, tape.split())
    assert chord < taut < contact
    assert re.fullmatch(r"0\.6\d+ MINIMUM", natural)
    back, front = map(float, ways.strip("[]").split(","))
    assert back < front < 1.4 * back


def test_the_example_of_pyvista_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pyvista = pytest.importorskip("pyvista", minversion="0.48")
    pytest.importorskip("pygeodesic")
    _, _, example = blocks("python")
    bm.write_atlas(bm.load_sample("female_average"), tmp_path / "body.atlas")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    with pyvista.vtk_verbosity("off"):
        exec(example, {})


def test_the_atlas_of_the_format_is_valid_and_sound(tmp_path: Path) -> None:
    (example,) = blocks("json")
    file = tmp_path / "example.atlas"
    file.write_text(example, encoding="utf-8")
    atlas = bm.read_atlas(file)
    assert len(atlas) == 2
    assert bm.check_atlas(atlas) == ()
    assert atlas.landmarks.keys() == {"back neck point"}


def test_every_command_is_listed_and_every_listed_command_exists() -> None:
    listed = set(re.findall(r"^\| `bodymeasure (\w+)", README, flags=re.MULTILINE))
    assert listed == set(app.commands)


def test_every_path_that_is_named_is_there() -> None:
    root = Path(__file__).parents[1]
    named = re.findall(r"\]\(([^)]+)\)", README)
    named += re.findall(r"`((?:bodymeasure|tests|viewer|\.ci)/[\w./]+|\.ci/run)`", README)
    assert len(named) >= 4
    for path in named:
        assert (root / path).exists(), path
