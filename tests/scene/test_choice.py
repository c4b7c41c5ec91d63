from collections.abc import Iterator

import pytest

from bodymeasure.errors import InputError
from bodymeasure.scene import choose_renderer
from bodymeasure.scene.drawing import opengl_check as choice


@pytest.fixture(autouse=True)
def _forget(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.delenv(choice.VARIABLE, raising=False)
    choice.opengl_trouble.cache_clear()
    yield
    choice.opengl_trouble.cache_clear()


@pytest.fixture
def _vtk_dies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "PROBE", "import os; os.abort()")


@pytest.mark.usefixtures("_vtk_dies")
def test_when_vtk_kills_its_process_we_draw_ourselves() -> None:
    chosen = choose_renderer()
    assert chosen.renderer == "software"
    assert "without OpenGL" in chosen.note
    assert "EGL" in chosen.note


def test_a_picture_that_comes_out_blank_is_no_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "PROBE", "print('blank [0, 0, 0]')")
    assert choose_renderer().renderer == "software"


@pytest.mark.usefixtures("_vtk_dies")
def test_the_probe_runs_once(monkeypatch: pytest.MonkeyPatch) -> None:
    first = choose_renderer()
    monkeypatch.setattr(choice, "PROBE", "print('drawn')")
    assert choose_renderer() == first


@pytest.mark.usefixtures("_vtk_dies")
def test_asking_for_what_cannot_draw_is_an_error() -> None:
    with pytest.raises(InputError, match=r"renderer is 'pyvista', but VTK found no OpenGL"):
        choose_renderer("pyvista")


def test_software_needs_no_probe(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "PROBE", "import time; time.sleep(1000)")
    monkeypatch.setenv(choice.VARIABLE, "software")
    assert choose_renderer() == ("software", "")


def test_the_argument_comes_before_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(choice.VARIABLE, "nonsense")
    assert choose_renderer("software").renderer == "software"
    with pytest.raises(InputError, match=r"BODYMEASURE_RENDERER is 'nonsense'; expected 'pyvista'"):
        choose_renderer()


@pytest.mark.slow
def test_the_probe_finds_real_trouble(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    assert "display" in choice.opengl_trouble(window=True)


def test_opengl_is_tried_beside_other_work_and_once(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[str] = []
    monkeypatch.setattr(choice, "find_spec", lambda name: calls.append(name))
    with choice.opengl_tried_beside():
        pass
    assert choice.choose_renderer().note.endswith("pyvista is not installed.")
    assert calls == ["pyvista"]


def test_opengl_is_not_tried_where_a_renderer_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(choice.VARIABLE, choice.SOFTWARE)
    monkeypatch.setattr(choice, "find_spec", lambda name: pytest.fail(name))
    with choice.opengl_tried_beside():
        pass
    assert choice.choose_renderer().renderer == choice.SOFTWARE
