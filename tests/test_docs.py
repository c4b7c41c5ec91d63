"""The documentation: its code runs, its links lead somewhere, and what it names is there."""

import re
import shlex
from pathlib import Path

import click
import pytest
from helpers import api_page

import bodymeasure as bm
from bodymeasure.cli.docs import FOLDER, PAGES
from bodymeasure.cli.main import app

ROOT = Path(bm.__file__).parents[1]
FILES = [ROOT / "README.md", *sorted((ROOT / ".github").glob("*.md")), *sorted(FOLDER.glob("*.md"))]
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", flags=re.MULTILINE | re.DOTALL)
every_file = pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)


@pytest.mark.parametrize(
    "page",
    [
        "quickstart",
        "charts",
        "landmarks",
        "python",
        "surveys",
        pytest.param("pyvista", marks=pytest.mark.slow),
        pytest.param("viewer", marks=pytest.mark.slow),
    ],
)
def test_the_examples_of_a_page_run_and_print_what_it_says(
    page: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("igl")
    if page == "pyvista":
        pyvista = pytest.importorskip("pyvista", minversion="0.48")
        monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    monkeypatch.chdir(tmp_path)
    if page != "pyvista":
        bm.write_atlas(bm.load_sample("female_average"), "body.atlas")
    names: dict[str, object] = {}
    for language, content in BLOCK.findall((FOLDER / f"{page}.md").read_text("utf-8")):
        if language == "toml":
            Path("mine.toml").write_text(content, encoding="utf-8")
        elif language == "python":
            assert capsys.readouterr().out == "", "the page does not say what is printed"
            exec(content, names)
        elif language == "text":
            assert capsys.readouterr().out == content
    assert capsys.readouterr().out == "", "the page does not say what is printed"


# The docstrings on the page of the API put other words in the same type.
@pytest.mark.parametrize(
    "file", [file for file in FILES if file.stem != "api"], ids=lambda file: file.stem
)
def test_every_command_that_is_named_is_there_with_its_options(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    lines = [
        line
        for language, block in BLOCK.findall(text)
        if language == "sh"
        for line in block.splitlines()
    ]
    lines += re.findall(r"`(bodymeasure [a-z][^`]*)`", BLOCK.sub("", text))
    for line in lines:
        for words in _commands(shlex.split(line)):
            command: click.Command = app
            while isinstance(command, click.Group) and words:
                inner = command.get_command(click.Context(command), words[0])
                if inner is None:
                    break
                command, words = inner, words[1:]
            known = {option for each in command.params for option in each.opts} | {"--help"}
            if isinstance(command, click.Group):
                assert command is not app, line
                known |= {"-o"}
            asked = {word for word in words if re.match(r"--?[a-z]", word)}
            assert asked <= known, line


def _commands(words: list[str]) -> list[list[str]]:
    """Return the words after each `bodymeasure` of a shell's line, as far as they are its own."""
    line = " ".join(shlex.quote(word) for word in words).replace("'&&'", "&&")
    parts = [shlex.split(part) for part in line.split("&&")]
    return [part[1:] for part in parts if part and part[0].split("/")[-1] == "bodymeasure"]


@every_file
def test_every_link_and_path_leads_somewhere(file: Path) -> None:
    text = BLOCK.sub("", file.read_text(encoding="utf-8"))
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", text):
        if "://" not in target:
            assert (file.parent / target).exists(), target
    for path in re.findall(r"(?<![\w/])(?:bodymeasure|tests|viewer|\.ci|\.github)/[\w./]+", text):
        assert (ROOT / path.rstrip(".")).exists(), path


@every_file
def test_every_public_name_that_is_written_is_there(file: Path) -> None:
    for name in re.findall(r"\bbm\.(\w+)", file.read_text(encoding="utf-8")):
        assert name in bm.__all__, name


def test_every_page_is_listed_and_has_a_title() -> None:
    assert sorted(PAGES) == sorted(path.stem for path in FOLDER.glob("*.md"))
    for page in PAGES:
        assert (FOLDER / f"{page}.md").read_text(encoding="utf-8").startswith("# ")


def test_the_atlas_of_the_format_is_valid_and_sound(tmp_path: Path) -> None:
    text = (FOLDER / "atlas_format.md").read_text(encoding="utf-8")
    (example,) = (content for language, content in BLOCK.findall(text) if language == "json")
    file = tmp_path / "example.atlas"
    file.write_text(example, encoding="utf-8")
    atlas = bm.read_atlas(file)
    assert len(atlas) == 2
    assert bm.check_atlas(atlas) == ()
    assert atlas.landmarks.keys() == {"back neck point"}


def test_the_page_of_the_api_is_new() -> None:
    text = (FOLDER / "api.md").read_text(encoding="utf-8")
    assert text == api_page.page(), "write it anew: python tests/helpers/api_page.py"
