from pathlib import Path

import click
import pytest
from helpers.command_line import Run

from bodymeasure.cli.docs import FOLDER, PAGES


def test_the_pages_are_listed_with_their_titles(run: Run) -> None:
    ran = run("docs")
    assert (ran.code, ran.err) == (0, "")
    assert [line.split()[0] for line in ran.out.splitlines()[1:]] == list(PAGES)
    assert "Charts of body measurements" in ran.out


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_printed_as_it_is(run: Run, page: str) -> None:
    ran = run("docs", page)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == (FOLDER / f"{page}.md").read_text(encoding="utf-8")


def test_an_unknown_page_is_refused_with_the_nearest_one(run: Run) -> None:
    ran = run("docs", "landmark")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == "Error: no page is named 'landmark'; did you mean 'landmarks'?\n"


def test_opened_pages_link_to_each_other(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(click, "launch", opened.append)
    monkeypatch.setattr("tempfile.mkdtemp", lambda prefix: str(tmp_path / prefix))
    (tmp_path / "bodymeasure-docs-").mkdir()
    ran = run("docs", "accuracy", "--open")
    assert (ran.code, ran.out) == (0, "")
    file = Path(opened[0])
    assert file.name == "accuracy.html"
    assert str(file) in ran.err.replace("\n", "")
    html = file.read_text(encoding="utf-8")
    assert "<table>" in html
    assert 'src="error_against_time.svg"' in html
    folder = file.parent
    assert sorted(path.stem for path in folder.glob("*.html")) == sorted(PAGES)
    assert (folder / "error_against_time.svg").is_file()
    assert 'href="charts.html"' in (folder / "quickstart.html").read_text(encoding="utf-8")
