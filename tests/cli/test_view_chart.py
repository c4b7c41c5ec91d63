"""`bodymeasure view --chart`."""

from pathlib import Path

import pytest
from helpers.command_line import Run
from PIL import Image

from bodymeasure.scene.drawing import opengl_check as choice

DEFINITIONS = """\
format = "bodymeasure measurements"
version = 1
name = "Two"

[[measurement]]
key = "hip"
kind = "girth"
name = "Hip girth"
group = "Girths"
at = "front hip point"

[[measurement]]
key = "half_hip"
kind = "formula"
name = "Half the hip girth"
formula = "hip / 2"

[[measurement]]
key = "eighth"
kind = "formula"
name = "An eighth of a turn"
formula = "atan(1)"
angle = true

[[measurement]]
key = "calf"
kind = "girth"
name = "Calf girth"
at = "calf point"
"""


@pytest.fixture
def definitions(tmp_path: Path) -> Path:
    path = tmp_path / "two.toml"
    path.write_text(DEFINITIONS)
    return path


@pytest.mark.parametrize(
    ("key", "message"),
    [
        ("hop", "there is no measurement 'hop' in 'Two'; did you mean 'hip'?"),
        ("eighth", "eighth: there is no tape to show: what it is calculated from has none"),
        ("calf", "calf: there is no tape to show: "),
    ],
)
def test_a_measurement_that_cannot_be_shown_is_told(
    run: Run, tmp_path: Path, definitions: Path, key: str, message: str
) -> None:
    picture = tmp_path / "body.png"
    options = ("--set", definitions, "--measure", key, "--screenshot", picture)
    ran = run("view", "female_average", "--chart", *options)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert not picture.exists()


def test_a_body_on_which_nothing_was_measured_is_told(run: Run, tmp_path: Path) -> None:
    picture = tmp_path / "body.png"
    ran = run("view", "paraboloid", "--chart", "--screenshot", picture)
    assert (ran.code, ran.out) == (2, "")
    assert "there is no tape to show, since nothing was measured; neck_girth: the " in ran.err
    assert "add it with `bodymeasure landmarks`" in ran.err
    assert not picture.exists()


@pytest.mark.parametrize("option", [("--measure", "hip"), ("--set", "two.toml")])
def test_options_of_the_chart_need_it(run: Run, option: tuple[str, str]) -> None:
    ran = run("view", "female_average", *option)
    assert ran.code == 2
    assert "--measure and --set are about measurements; add --chart." in ran.err


@pytest.mark.slow
def test_a_measurement_is_drawn_without_opengl(
    run: Run, tmp_path: Path, definitions: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    choice.opengl_trouble.cache_clear()
    monkeypatch.setattr(choice, "PROBE", "import os; os.abort()")
    picture = tmp_path / "body.png"
    options = ("--set", definitions, "--measure", "hip", "--screenshot", picture)
    ran = run("view", "female_average", "--chart", *options)
    choice.opengl_trouble.cache_clear()
    assert (ran.code, ran.out.strip()) == (0, str(picture))
    assert "without OpenGL" in ran.err
    with Image.open(picture) as image:
        assert image.size == (600, 500)
