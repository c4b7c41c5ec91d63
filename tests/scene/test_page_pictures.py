"""Pictures for pages: small files, whose sizes a page finds, in colors that its legend shows."""

import io
from importlib.resources import files

import numpy as np
from PIL import Image

from bodymeasure.chart import TapeKind
from bodymeasure.report.templating import data_uri, images
from bodymeasure.scene.figures.canvas import png, webp
from bodymeasure.scene.tapes.mesh import BAND, COLORS


def shaded(width: int, height: int) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    x, y = np.meshgrid(np.linspace(0, 3, width), np.linspace(0, 2, height))
    gray = 128 + 90 * np.sin(x) * np.cos(y)
    return np.repeat(gray[..., None], 3, axis=2).astype(np.uint8)


def test_a_page_knows_the_sizes_of_its_pictures() -> None:
    picture = shaded(600, 500)
    found = images({"a": png(picture), "b": webp(picture)})
    assert [(each["width"], each["height"]) for each in found.values()] == [(600, 500)] * 2
    assert found["a"]["uri"].startswith("data:image/png;base64,")
    assert found["b"]["uri"].startswith("data:image/webp;base64,")
    assert data_uri(b"<svg/>").startswith("data:image/svg+xml;base64,")


def test_pictures_for_pages_are_small_and_look_the_same() -> None:
    picture = shaded(600, 500)
    small = webp(picture)
    assert 5 * len(small) < len(png(picture))
    again = np.asarray(Image.open(io.BytesIO(small)).convert("RGB")).astype(float)
    assert np.abs(again - picture).mean() < 2.0


def test_the_legend_has_the_colors_of_the_tapes() -> None:
    css = files("bodymeasure.report").joinpath("templates", "measurements.css").read_text("utf-8")
    for name, color in {
        "contact": COLORS[TapeKind.CONTACT],
        "taut": COLORS[TapeKind.TAUT],
        "straight": COLORS[TapeKind.STRAIGHT],
    }.items():
        digits = "".join(f"{round(255 * part):02x}" for part in color)
        assert f".{name} {{ background: #{digits}; }}" in css
    assert "".join(f"{round(255 * part):02x}" for part in BAND) in css
