"""`bodymeasure view --export`."""

import base64
import gzip
import re
from pathlib import Path

import pytest
from helpers.command_line import Run

from bodymeasure.formats import write_atlas
from bodymeasure.samples import load_sample

# Messages stand in the page as gzip files in base64.
PACKED = re.compile(rb'"(H4sI[A-Za-z0-9+/=]+)"')


@pytest.mark.slow
def test_a_page_is_written_with_the_chart_that_is_asked_for(run: Run, tmp_path: Path) -> None:
    write_atlas(load_sample("female_average"), tmp_path / "anna.atlas")
    write_atlas(load_sample("paraboloid"), tmp_path / "dish.atlas")
    for name, chart, holds in (("dish", (), False), ("anna", ("--chart", "trousers"), True)):
        path = tmp_path / f"page{holds}.html"
        ran = run("view", tmp_path / f"{name}.atlas", *chart, "--export", path)
        assert (ran.code, ran.out) == (0, f"{path}\n")
        page = path.read_bytes()
        assert (b'"chart": "' in page) == holds
        assert len(page) < 3e6
        # Where the file lies at home is nobody's business, also in what is packed.
        messages = [gzip.decompress(base64.b64decode(text)) for text in PACKED.findall(page)]
        assert len(messages) == 1 + holds
        assert any(f'"{name}.atlas"'.encode() in message for message in messages)
        for content in (page, *messages):
            assert str(tmp_path).encode() not in content


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--export", "page.png"), "page.png: the page is an HTML file; give a name that ends"),
        (("--export", "gone/page.html"), "gone/page.html: cannot be written"),
        (("gone.atlas", "--export", "page.html"), "gone.atlas: no such file"),
        (("--export", "page.html", "--desktop"), "--export writes the page; it goes with neither"),
        (("--export", "page.html", "--set", "a.toml"), "add --chart"),
    ],
)
def test_a_page_that_cannot_be_written_is_told(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = run("view", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert list(tmp_path.iterdir()) == []
