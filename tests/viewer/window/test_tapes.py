import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer import describe_measured, view_chart
from bodymeasure.viewer.window.clicks import PICK_TOLERANCE
from bodymeasure.viewer.window.tapes import TapeWindow
from helpers.charts.hand_charts import chart_of, chord_between, girth_at, height_of, missing
from PIL import Image

from bodymeasure.chart import Chart
from bodymeasure.errors import InputError
from bodymeasure.samples import load_sample
from bodymeasure.scene.drawing import opengl_check as choice


@pytest.fixture(scope="module")
def chart() -> Chart:
    body = load_sample("female_average")
    return chart_of(
        body,
        [
            missing("cervicale_height"),
            girth_at(body, "bust point left"),
            girth_at(body, "back waist point"),
            chord_between(body, "bust point left", "bust point right"),
            height_of(body, "shoulder point left"),
        ],
    )


@pytest.fixture
def _no_opengl(monkeypatch: pytest.MonkeyPatch) -> Any:
    choice.opengl_trouble.cache_clear()
    monkeypatch.setattr(choice, "PROBE", "import os; os.abort()")
    yield
    choice.opengl_trouble.cache_clear()


@pytest.fixture
def window(chart: Chart) -> Any:
    if choice.opengl_trouble():
        pytest.skip(choice.opengl_trouble())
    import pyvista

    with pyvista.vtk_verbosity("off"):
        made = TapeWindow(chart, off_screen=True)
        yield made
        made.plotter.close()


def test_a_measurement_is_described_in_centimeters(chart: Chart) -> None:
    bust = chart.measured[1]
    name, value = describe_measured(bust, chart.atlas.unit).splitlines()
    assert name == "bust point left (girth_bust_point_left)"
    assert value == f"{100 * bust.value:.2f} cm"
    assert describe_measured(chart.measured[0], chart.atlas.unit).splitlines() == [
        "cervicale_height (cervicale_height)",
        "no landmark cervicale",
    ]


@pytest.mark.usefixtures("_no_opengl")
def test_without_a_display_the_way_out_is_named(chart: Chart) -> None:
    with pytest.raises(InputError, match=r"no window can be opened.*display.*--screenshot"):
        view_chart(chart)


@pytest.mark.slow
@pytest.mark.usefixtures("_no_opengl")
@pytest.mark.parametrize(("key", "size"), [("girth_bust_point_left", (600, 500)), (None, None)])
def test_without_opengl_tapes_are_drawn_all_the_same(
    chart: Chart, tmp_path: Path, key: str | None, size: tuple[int, int] | None
) -> None:
    path = tmp_path / "body.png"
    assert "without OpenGL" in view_chart(chart, path, key=key)
    image = Image.open(io.BytesIO(path.read_bytes()))
    assert size in (None, image.size)
    assert image.size[0] > image.size[1]


@pytest.mark.slow
def test_picking_a_tape_names_its_measurement(window: Any, chart: Chart) -> None:
    import pyvista

    plotter = window.plotter
    plotter.screenshot(None, return_img=True)
    size = tuple(plotter.window_size)
    line = window.scene.tapes[0]
    front = line.points[np.argmin(line.points[:, 1])]
    (x, y), _ = window.framed("front").project(front, size)
    picker = pyvista._vtk.vtkCellPicker()
    picker.SetTolerance(PICK_TOLERANCE)
    picker.Pick(x, size[1] - y, 0.0, plotter.renderer)
    words = window.pick(picker.GetDataSet(), picker.GetCellId())
    assert words == describe_measured(chart["girth_bust_point_left"], chart.atlas.unit)
    # Half-way between waist and crotch there is only skin.
    skin = chart.atlas.position(chart.atlas.landmarks["front hip point"])
    (x, y), _ = window.framed("front").project(skin, size)
    picker.Pick(x, size[1] - y, 0.0, plotter.renderer)
    assert picker.GetCellId() >= 0
    assert window.pick(picker.GetDataSet(), picker.GetCellId()) == ""
    assert window.pick(None, -1) == ""


@pytest.mark.slow
def test_keys_go_through_the_groups_and_hide_numbers(window: Any) -> None:
    def shot() -> Any:
        return np.asarray(window.plotter.screenshot(None, return_img=True)).astype(int)[100:]

    def orange(image: Any) -> int:
        return int(((image[..., 0] - image[..., 2] > 90) & (image[..., 0] > 120)).sum())

    first = shot()
    assert orange(first) > 300
    window.toggle_numbers()
    assert (shot().max(axis=-1) < 60).sum() < (first.max(axis=-1) < 60).sum()
    assert window.next_group() == "Widths"
    assert orange(shot()) == 0
    assert window.next_group() == "Heights"
    assert window.next_group() == ""
    assert orange(shot()) > 300
    window.look_from("left")
    shown = (shot() < 250).any(axis=-1).any(axis=0)
    assert shown.sum() < 0.6 * (first < 250).any(axis=-1).any(axis=0).sum()


@pytest.mark.slow
def test_names_and_values_stand_beside_their_numbers(window: Any, chart: Chart) -> None:
    girths = [item for item in chart.measured if item.definition.key.startswith("girth")]
    expected = [
        f"{window.scene.numbers[item.definition.key]}   {100 * item.value:.2f} cm   "
        f"{item.definition.name}"
        for item in girths
    ]
    assert window.listed() == expected
    window.next_group()
    (line,) = window.listed()
    assert line.endswith("cm   bust point left, bust point right")
    for _ in range(2):
        window.next_group()
    assert len(window.listed()) == 4
    # In a low window, the list says how many more there are.
    window.plotter.window_size = [600, 170]
    window.fit_texts()
    assert window.listed()[-1] == f"and {4 - len(window.listed()) + 1} more"
    assert window.plotter.actors["list"].input.splitlines() == window.listed()


@pytest.mark.slow
def test_one_measurement_is_shown_alone(chart: Chart, tmp_path: Path) -> None:
    if choice.opengl_trouble():
        pytest.skip(choice.opengl_trouble())
    path = tmp_path / "span.png"
    assert view_chart(chart, path, key="chord_bust_point_left_bust_point_right") == ""
    image = np.asarray(Image.open(io.BytesIO(path.read_bytes()))).astype(int)
    body = image[100:900]
    # There is one straight line between the bust points, drawn over the body without colors.
    assert (body.max(axis=-1) - body.min(axis=-1)).max() < 60
    dark = (body.max(axis=-1) < 70).sum(axis=1)
    span = chart["chord_bust_point_left_bust_point_right"].value
    scene_height = 1.15 * 1.3759 * 1.04
    assert dark.max() == pytest.approx(span / scene_height * image.shape[0], rel=0.1)
