from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer.window import tape_tool
from bodymeasure.viewer.window.describe import describe_path
from bodymeasure.viewer.window.patches import Window
from bodymeasure.viewer.window.places import place_on
from helpers.charts.scanned import SURFACE, scanned
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas, closest_point
from bodymeasure.errors import ConvergenceError
from bodymeasure.geodesic import geodesic_between
from bodymeasure.report.numbers import at_most
from bodymeasure.samples import load_sample
from bodymeasure.scene.drawing.opengl_check import opengl_trouble

FROM, TO = "bust point left", "front waist point"


@pytest.fixture(scope="module")
def body() -> Atlas:
    return load_sample("female_average")


@pytest.fixture
def window(body: Atlas) -> Iterator[Any]:
    if opengl_trouble():
        pytest.skip(opengl_trouble())
    import pyvista

    with pyvista.vtk_verbosity("off"):
        made = Window(straight_survey(body), off_screen=True)
        made.plotter.screenshot(None, return_img=True)
        yield made
        made.plotter.close()


class Pointer:
    """Somebody at the mouse and the keys of a window."""

    def __init__(self, window: Any) -> None:
        self.window = window
        self.events = window.plotter.iren.interactor

    def place_of(self, position: Any) -> tuple[int, int]:
        """Where a position is seen from the front, in pixels from the left and the bottom."""
        width, height = self.window.plotter.window_size
        (x, y), _ = self.window.framed("front").project(np.asarray(position), (width, height))
        return round(x), round(height - y)

    def move(self, x: int, y: int) -> None:
        self.events.SetEventInformation(x, y)
        self.events.MouseMoveEvent()

    def press(self, x: int, y: int, *, and_move: tuple[int, int] = (0, 0)) -> None:
        """Press the left button, move, and release it."""
        self.move(x, y)
        self.events.LeftButtonPressEvent()
        self.move(x + and_move[0], y + and_move[1])
        self.events.LeftButtonReleaseEvent()

    def key(self, name: str) -> None:
        self.events.SetKeySym(name)
        self.events.KeyPressEvent()


@pytest.fixture
def pointer(window: Any) -> Pointer:
    return Pointer(window)


@pytest.fixture
def said(window: Any, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    words: list[str] = []
    say = window.say

    def listen(text: str) -> None:
        words.append(text)
        say(text)

    monkeypatch.setattr(window, "say", listen)
    return words


def _green(window: Any) -> int:
    image = np.asarray(window.plotter.screenshot(None, return_img=True)).astype(int)
    return int(((image[..., 1] - image[..., 0] > 60) & (image[..., 1] > image[..., 2])).sum())


def _at(body: Atlas, name: str) -> Any:
    return body.position(body.landmarks[name])


@pytest.mark.slow
def test_two_clicks_make_a_tape_with_its_length_and_error(
    window: Any, body: Atlas, pointer: Pointer, said: list[str]
) -> None:
    pointer.key("t")
    pointer.key("d")
    plain = _green(window)
    pointer.press(*pointer.place_of(_at(body, FROM)))
    pointer.press(*pointer.place_of(_at(body, TO)))
    expected = geodesic_between(body, FROM, TO)
    (path,) = window.tool.tapes
    assert path.length == expected.length
    straight = np.linalg.norm(_at(body, FROM) - _at(body, TO))
    assert said[-1].splitlines() == [
        f"tape 1: {FROM} to {TO}",
        f"{100 * expected.length:.2f} cm, error {at_most(expected.error_estimate, body.unit)}",
        f"straight {100 * straight:.2f} cm",
        expected.status.sentence,
    ]
    assert _green(window) > plain + 300
    # The next click begins the next tape, and z takes back first its start and then the tape.
    pointer.press(*pointer.place_of(_at(body, TO)))
    assert said[-1] == f"from {TO}; {tape_tool.END}"
    for words, left in ((tape_tool.START, 1), ("tape 1 was taken away", 0), ("there is no", 0)):
        pointer.key("z")
        assert said[-1].startswith(words)
        assert len(window.tool.tapes) == left
    pointer.move(3, 3)
    assert _green(window) == plain


@pytest.mark.slow
def test_a_press_that_moves_turns_the_body_and_picks_nothing(
    window: Any, body: Atlas, pointer: Pointer, said: list[str]
) -> None:
    place = pointer.place_of(_at(body, FROM))
    before = window.plotter.camera.position
    pointer.press(*place, and_move=(40, 0))
    assert window.plotter.camera.position != before
    assert said == []
    window.look_from("front")
    pointer.press(*place, and_move=(2, 2))
    assert said[-1].startswith(body.patch_names[body.landmarks[FROM].patch][:4])
    # With the tape tool, too, a press that turns is no end of a tape.
    pointer.key("t")
    window.look_from("front")
    pointer.press(*place, and_move=(40, 0))
    assert said[-1] == tape_tool.START


@pytest.mark.slow
def test_clicks_snap_to_landmarks_and_say_so_before(
    window: Any, body: Atlas, pointer: Pointer
) -> None:
    x, y = pointer.place_of(_at(body, FROM))
    assert window.tool.hover(x, y) is None
    window.toggle_tape_tool()
    assert window.tool.hover(x + 4, y - 4) == FROM
    pointer.move(x + 4, y - 4)
    assert any("landmark" in name for name in window.plotter.actors)
    assert window.tool.hover(x + 14, y) is None
    assert f"from {FROM};" in window.clicked(x + 4, y - 4)
    # A landmark on the back is not meant by a click on the front.
    place = pointer.place_of(_at(body, "back waist point"))
    assert window.tool.hover(*place) != "back waist point"


@pytest.mark.slow
def test_clicks_beside_the_body_and_twice_on_a_spot_make_no_tape(
    window: Any, body: Atlas, pointer: Pointer
) -> None:
    window.toggle_tape_tool()
    assert window.clicked(3, 300) == tape_tool.BESIDE
    place = pointer.place_of(_at(body, FROM))
    window.clicked(*place)
    assert window.clicked(*place) == tape_tool.SLIP
    # The start is kept for the next click.
    assert "tape 1" in window.clicked(*pointer.place_of(_at(body, TO)))
    # Putting the tool down drops a start.
    window.clicked(*place)
    window.toggle_tape_tool()
    window.toggle_tape_tool()
    assert "click where the tape is to end" in window.clicked(*place)


@pytest.mark.slow
def test_a_tape_without_a_length_is_said_and_not_drawn(
    window: Any, body: Atlas, pointer: Pointer, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_args: object) -> None:
        raise ConvergenceError("no path met the tolerance; measure to a point in between")

    monkeypatch.setattr(tape_tool, "geodesic_between", fail)
    window.toggle_tape_tool()
    window.clicked(*pointer.place_of(_at(body, FROM)))
    words = window.clicked(*pointer.place_of(_at(body, TO)))
    assert words.startswith(f"from {FROM} to {TO}: no length.\nno path met the tolerance")
    assert window.tool.tapes == []


@pytest.mark.slow
def test_points_between_landmarks_are_those_under_the_pointer(
    window: Any, body: Atlas, pointer: Pointer, rng: np.random.Generator
) -> None:
    window.toggle_tape_tool()
    triangles = window.surface.triangles
    for row in rng.integers(len(triangles), size=20):
        corners = window.surface.points[triangles[row]]
        position = rng.dirichlet((1.0, 1.0, 1.0)) @ corners
        point = place_on(window.surface, row, position)
        assert point.patch == window.surface.patch[row]
        # The tessellation is within half a millimeter of the surface.
        assert np.linalg.norm(body.position(point) - position) < 1e-3
    middle = (_at(body, FROM) + _at(body, "bust point right")) / 2
    x, y = pointer.place_of(middle)
    window.clicked(x, y)
    words = window.clicked(*pointer.place_of(_at(body, TO)))
    assert "tape 1: a point on " in words
    start = window.tool.tapes[0].points[0]
    placed = pointer.place_of(body.position(start))
    assert np.hypot(placed[0] - x, placed[1] - y) < 1.5
    assert closest_point(body, body.position(start))[1] < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("size", [(1024, 700), (640, 480)])
def test_the_help_fits_the_window(window: Any, size: tuple[int, int]) -> None:
    from bodymeasure.viewer.window.base import HELP

    plotter = window.plotter
    plotter.window_size = list(size)
    window.show_help(("click: what is there", "n: patch edges", "d: diagonals", *HELP))
    image = np.asarray(plotter.screenshot(None, return_img=True))
    assert image.shape[:2] == size[::-1]
    actor = plotter.actors["help"]
    box = [0.0] * 4
    actor.GetBoundingBox(plotter.renderer, box)
    left, right, bottom, top = (
        value + place for value, place in zip(box, np.repeat(actor.position, 2), strict=True)
    )
    assert 0 <= left < right <= size[0]
    assert 0 <= bottom < top <= 0.2 * size[1]
    assert all(part in actor.input for part in ("t: tape", "q: close", "F4 right", "d: diagonals"))
    # The body stands above it.
    view = window.framed("front")
    _, y = view.project(window.surface.points, size)[0].T
    assert y.min() > 0
    assert y.max() < size[1] - top


def test_on_a_scan_the_words_say_how_far_it_is(body: Atlas) -> None:
    """The error of the computation is the smallest part of what is unknown there."""

    def words(atlas: Atlas) -> str:
        return describe_path(geodesic_between(atlas, FROM, TO), 0.1)

    assert "scan" not in words(body)
    off = f"{1000 * SURFACE:.3f}\N{NO-BREAK SPACE}mm"
    assert f"The surface is {off} from the scan there" in words(scanned(body))
    unseen = words(scanned(body, [body.landmarks[FROM].patch]))
    assert "that part is a guess" in unseen
