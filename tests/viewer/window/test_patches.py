import io
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer import describe, view
from bodymeasure.viewer.window.clicks import PICK_TOLERANCE
from bodymeasure.viewer.window.patches import Window
from helpers.charts.straight_survey import straight_survey
from PIL import Image

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.samples import load_sample
from bodymeasure.scene.drawing import opengl_check as choice


@pytest.fixture(scope="module")
def body() -> Atlas:
    return load_sample("female_average")


@pytest.fixture
def _no_opengl(monkeypatch: pytest.MonkeyPatch) -> Any:
    choice.opengl_trouble.cache_clear()
    monkeypatch.setattr(choice, "PROBE", "import os; os.abort()")
    yield
    choice.opengl_trouble.cache_clear()


@pytest.fixture
def _opengl() -> None:
    if choice.opengl_trouble():
        pytest.skip(choice.opengl_trouble())


def test_a_patch_is_described_in_centimeters(body: Atlas) -> None:
    missing = np.zeros((len(body), 2), dtype=bool)
    missing[7, 1] = True
    survey = straight_survey(body, difference=-2.5e-7, no_length=missing)
    name = body.patch_names[7]
    first, second, third = describe(survey, 7).splitlines()
    assert first.startswith(name)
    assert second == "(0, 0) - (1, 1): 10.0000 cm, -2.5e-07 from exact"
    assert third == "(1, 0) - (0, 1): no length; left its patch"
    assert describe(survey, 7, 1).splitlines() == [first, third]


@pytest.mark.usefixtures("_no_opengl")
def test_without_a_display_the_way_out_is_named(body: Atlas) -> None:
    with pytest.raises(InputError, match=r"no window can be opened.*display.*--screenshot"):
        view(straight_survey(body))


def test_without_pyvista_the_extra_is_named(body: Atlas, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(MissingExtraError, match=r"bodymeasure\[viewer\]"):
        view(straight_survey(body), Path("never.png"))


@pytest.mark.slow
@pytest.mark.usefixtures("_no_opengl")
def test_without_opengl_a_screenshot_is_drawn_all_the_same(body: Atlas, tmp_path: Path) -> None:
    note = view(straight_survey(body), tmp_path / "body.png")
    assert "without OpenGL" in note
    assert Image.open(io.BytesIO((tmp_path / "body.png").read_bytes())).size[1] > 900


@pytest.mark.slow
@pytest.mark.usefixtures("_opengl")
def test_a_screenshot_shows_the_body_and_its_color_bar(body: Atlas, tmp_path: Path) -> None:
    path = tmp_path / "body.png"
    assert view(straight_survey(body), path) == ""
    assert list(tmp_path.iterdir()) == [path]
    image = np.asarray(Image.open(io.BytesIO(path.read_bytes())))
    assert image.shape == (1100, 1000, 3)
    white = np.asarray((image > 250).all(axis=-1))
    assert 0.1 < 1.0 - white[100:900].mean() < 0.5
    # The color bar runs from the palest to the darkest color of the map.
    bar = image[1025:1045, 220:780].astype(float).mean(axis=(0, 2))
    assert bar[:20].mean() > bar[-20:].mean() + 50


@pytest.mark.slow
@pytest.mark.usefixtures("_opengl")
def test_a_screenshot_that_cannot_be_written_is_an_error(body: Atlas, tmp_path: Path) -> None:
    path = tmp_path / "missing" / "body.png"
    with pytest.raises(InputError, match=r"missing/body.png: cannot be written"):
        view(straight_survey(body), path)


@pytest.mark.slow
@pytest.mark.usefixtures("_opengl")
@pytest.mark.parametrize("landmark", ["bust point left", "bust point right", "front hip point"])
def test_picking_finds_the_patch_under_the_pointer(body: Atlas, landmark: str) -> None:
    import pyvista

    survey = straight_survey(body)
    with pyvista.vtk_verbosity("off"):
        window = Window(survey, off_screen=True)
        window.plotter.screenshot(None, return_img=True)
        window.toggle_paths()  # so that the surface is hit
        patch = body.landmarks[landmark].patch
        framed = window.framed("front")
        # This is halfway between the patch's middle and that of an edge, and on no diagonal.
        from bodymeasure.bezier import evaluate

        spot = evaluate(body.control_points[patch], (0.5, 0.25))
        (x, y), _ = framed.project(spot, tuple(window.plotter.window_size))
        picker = pyvista._vtk.vtkCellPicker()
        picker.SetTolerance(PICK_TOLERANCE)
        picker.Pick(x, window.plotter.window_size[1] - y, 0.0, window.plotter.renderer)
        words = window.pick(picker.GetDataSet(), picker.GetCellId())
        assert words == describe(survey, patch)
        assert window.pick(None, -1) == ""
        window.plotter.close()


@pytest.mark.slow
@pytest.mark.usefixtures("_opengl")
def test_picking_a_diagonal_names_only_it(body: Atlas) -> None:
    import pyvista

    survey = straight_survey(body)
    with pyvista.vtk_verbosity("off"):
        window = Window(survey, off_screen=True)
        mesh = next(
            actor.mapper.dataset for actor in window.path_actors if actor.mapper.dataset.n_cells
        )
        # There is one line for each path, in their order.
        assert window.pick(mesh, 2 * 30 + 1) == describe(survey, 30, 1)
        assert window.pick(mesh, 2 * 30) == describe(survey, 30, 0)
        window.plotter.close()


@pytest.mark.slow
@pytest.mark.usefixtures("_opengl")
def test_keys_hide_lines_and_turn_the_body(body: Atlas) -> None:
    import pyvista

    with pyvista.vtk_verbosity("off"):
        window = Window(straight_survey(body), off_screen=True)
        shots = []
        for change in (
            lambda: None,
            window.toggle_edges,
            window.toggle_paths,
            lambda: window.look_from("left"),
        ):
            change()
            image = np.asarray(window.plotter.screenshot(None, return_img=True)).astype(int)
            shots.append(image[60:900])
        window.plotter.close()
    saturation = [(shot.max(axis=-1) - shot.min(axis=-1) > 60).sum() for shot in shots]
    dark = [(shot.max(axis=-1) < 120).sum() for shot in shots]
    assert dark[1] < dark[0]
    assert saturation[1] > 5000
    assert saturation[2] == 0
    width = [np.ptp(np.nonzero((shot < 250).any(axis=-1))[1]) for shot in shots]
    assert width[3] < 0.5 * width[2]
