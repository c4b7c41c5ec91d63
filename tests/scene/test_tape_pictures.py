import io
from collections.abc import Mapping

import numpy as np
import pytest
from helpers.charts.hand_charts import chart_of, missing
from numpy.typing import NDArray
from PIL import Image

from bodymeasure._typing import Bools
from bodymeasure.atlas import Atlas
from bodymeasure.chart import Chart, TapeKind
from bodymeasure.errors import InputError
from bodymeasure.scene import SIDES, TapeScene, tape_pictures
from bodymeasure.scene.drawing.opengl_check import SOFTWARE
from bodymeasure.scene.drawing.picture import Draw, Picture
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.tapes.camera import best_sides
from bodymeasure.scene.tapes.closeup import SIZE, closeup
from bodymeasure.scene.tapes.gallery import body_picture, roomy_views, shown_sides
from bodymeasure.scene.tapes.label_layout import Columns
from bodymeasure.scene.tapes.labels import numbered
from bodymeasure.scene.tapes.mesh import BAND, COLORS, tape_mesh
from bodymeasure.scene.tapes.text import column_texts

PIXELS = 420
# How much darker or redder a pixel may be for what is mixed into it at a tube's edge.
TONE = 0.25


@pytest.fixture(scope="module")
def sides(scene: TapeScene, around: list[Sight]) -> Mapping[str, Sight]:
    """The side from which each measurement is looked at."""
    return best_sides(scene, around)


def like(image: NDArray[np.uint8], color: tuple[float, float, float]) -> Bools:
    """Pixels of a color, in any shade of it."""
    rgb = image / 255.0
    hue = np.array(color) / np.max(color)
    bright = rgb.max(axis=-1, keepdims=True)
    return np.asarray(
        (np.abs(rgb / np.maximum(bright, 0.05) - hue).max(axis=-1) < TONE) & (bright[..., 0] > 0.2)
    )


def test_tapes_are_drawn_where_they_are_seen(
    scene: TapeScene, seen: Mapping[str, Sight], draw: Draw
) -> None:
    nape = [line for line in scene.tapes if line.key.startswith("path")]
    tubes = tape_mesh(nape, 0.006, np.zeros(3))
    for side, drawn in (("front", False), ("back", True), ("front", False)):
        view = seen[side].view
        size = view.size(PIXELS)
        image = draw(Picture(scene.surface, view, size, tubes=tubes))
        blue = like(image, COLORS[TapeKind.CONTACT])
        assert image.shape == (size[1], size[0], 3)
        assert blue.any() == drawn
        if drawn:
            places, _ = view.project(nape[0].points, size)
            column, row = np.floor(places).astype(int).T
            assert blue[row, column].mean() > 0.95


@pytest.mark.slow
def test_contact_taut_and_straight_look_different(
    scene: TapeScene, sides: Mapping[str, Sight], draw: Draw
) -> None:
    bust, span = (
        draw(closeup(scene, key, sides[key]))
        for key in ("girth_bust_point_left", "chord_bust_point_left_bust_point_right")
    )
    assert bust.shape == span.shape == (SIZE[1], SIZE[0], 3)
    blue, orange = (like(bust, COLORS[kind]) for kind in (TapeKind.CONTACT, TapeKind.TAUT))
    band = like(bust, BAND) & (bust.max(axis=-1) - bust.min(axis=-1).astype(int) > 40)
    # All three are in the middle of the picture, where the tape bridges the hollow.
    middle = slice(SIZE[0] * 2 // 5, SIZE[0] * 3 // 5)
    for seen in (blue, orange, band):
        assert seen[:, middle].sum() > 30
    assert not like(span, COLORS[TapeKind.CONTACT]).any()
    dark = (span[:, middle].max(axis=-1) < 80).any(axis=0)
    assert dark.mean() > 0.9


def test_numbers_stand_beside_the_body(
    scene: TapeScene, seen: Mapping[str, Sight], draw: Draw, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("bodymeasure.scene.tapes.gallery.BODY_PIXELS", 600)
    monkeypatch.setattr("bodymeasure.scene.tapes.gallery.LABEL_PIXELS", 14)
    for side in ("front", "left"):
        blank = draw(body_picture(scene, scene.tapes, [], seen[side]))
        labeled = list(scene.numbers.values())
        image = draw(body_picture(scene, scene.tapes, labeled, seen[side]))
        assert blank.shape == image.shape
        margin = blank.min(axis=(0, 2)) == 255
        inked = image.min(axis=-1) < 250
        # There is ink in both margins, and none at the picture's border, so that nothing is cut
        # off.
        left = np.flatnonzero(~margin)[0]
        right = np.flatnonzero(~margin)[-1]
        assert inked[:, :left].any() or inked[:, right + 1 :].any()
        border = [inked[0], inked[-1], inked[:, 0], inked[:, -1]]
        assert not np.concatenate(border).any()


def test_labels_are_clear_of_the_silhouette_and_of_each_other(
    scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    for side in seen.values():
        size = side.view.size(1400)
        low, high = (size[0] * end for end in side.columns)
        columns = Columns(low - 16, high + 16, 0.0, size[1], 26)
        found, layout = numbered(scene.tapes, list(scene.numbers.values()), side, size, columns)
        texts = [str(number) for number in found]
        placed = column_texts(texts, layout, columns, layout.label_height)
        boxes = []
        for text in placed:
            width = 0.65 * text.size * len(text.text)
            left = text.x - width if text.horizontal == "right" else text.x
            boxes.append((left, text.y - text.size / 2, left + width, text.y + text.size / 2))
            assert left > 0.0
            assert left + width < size[0]
            first, last = (round(edge * side.size[0] / size[0]) for edge in (left, left + width))
            assert not np.isfinite(side.depth[:, first : last + 1]).any()
        for number, one in enumerate(boxes):
            for other in boxes[:number]:
                apart = (
                    one[2] <= other[0]
                    or other[2] <= one[0]
                    or one[3] <= other[1]
                    or other[3] <= one[1]
                )
                assert apart


@pytest.mark.slow
def test_all_pictures_of_a_chart(chart: Chart, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bodymeasure.scene.tapes.gallery.BODY_PIXELS", 300)
    drawn_names: list[str] = []
    # Without a value, girth of the waist, nape to waist.
    few = chart_of(chart.atlas, [chart.measured[number] for number in (0, 2, 5)])
    shots = tape_pictures(few, renderer=SOFTWARE, advance=drawn_names.append)
    assert (shots.renderer, shots.note) == (SOFTWARE, "")
    keys = [item.definition.key for item in few.measured[1:]]
    assert list(shots.closeups) == keys
    assert list(shots.numbers) == keys
    assert list(shots.body)[-1] == ("Lengths", "back")
    assert set(list(shots.body)[:-1]) == {("Girths", side) for side in SIDES}
    assert len(drawn_names) == len(shots.body) + len(shots.closeups)
    sizes = {Image.open(io.BytesIO(file)).size for file in shots.closeups.values()}
    assert sizes == {SIZE}
    heights = {Image.open(io.BytesIO(file)).size[1] for file in shots.body.values()}
    assert heights == {300}


@pytest.mark.slow
def test_few_pictures_number_every_measurement_once(
    chart: Chart, scene: TapeScene, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("bodymeasure.scene.tapes.gallery.BODY_PIXELS", 60)
    shots = tape_pictures(chart, few=True, renderer=SOFTWARE)
    assert not shots.closeups
    views = roomy_views(scene, chart.atlas.axes)
    shown = shown_sides(scene, {side: sight(scene.surface, view) for side, view in views.items()})
    groups = {line.key: line.group for line in scene.tapes}
    for key, group in groups.items():
        assert any((group, side) in shots.body for side in shown[key])
    # Each picture numbers a measurement that no other of its group does.
    for group, side in shots.body:
        own = [key for key in shown if groups[key] == group]
        others = {other for name, other in shots.body if name == group} - {side}
        assert any(side in shown[key] and not shown[key] & others for key in own)


def test_a_chart_without_tapes_has_no_pictures(square: Atlas) -> None:
    shots = tape_pictures(chart_of(square, [missing("nothing")]), renderer=SOFTWARE)
    assert not shots.body
    assert not shots.closeups
    assert not shots.numbers


def test_an_unknown_renderer_is_named(chart: Chart) -> None:
    with pytest.raises(InputError, match="renderer is 'povray'"):
        tape_pictures(chart, renderer="povray")
