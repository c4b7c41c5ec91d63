"""The body is drawn, from five sides, in two projections, by day and by night, with its layers."""

import io
import re
from collections.abc import Callable
from typing import Any, Literal

import numpy as np
import pytest
from bodymeasure.viewer.content.body import seam_sides
from bodymeasure.viewer.content.layers import layer_message
from bodymeasure.viewer.content.quantities import seam_angles
from bodymeasure.viewer.content.requests import ShowLayer
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from helpers.viewer_page import Screen
from PIL import Image

import bodymeasure as bm
from bodymeasure.atlas import EDGES

VIEWS = ("front", "back", "left", "right", "top")


def picture(screen: Screen) -> "np.ndarray[tuple[int, int, int], np.dtype[np.int64]]":
    """The scene as it is on the screen, without what lies over it."""
    screen.page.wait_for_timeout(250)
    # Labels and buttons have colors of their own, which would count as the body's.
    screen.page.evaluate(
        """() => {
          for (const element of document.querySelector("[data-testid=scene]").children) {
            if (element.tagName !== "CANVAS") element.style.visibility = "hidden";
          }
        }"""
    )
    content = screen.page.locator("canvas").screenshot()
    screen.page.evaluate(
        """() => {
          for (const element of document.querySelector("[data-testid=scene]").children) {
            element.style.visibility = "";
          }
        }"""
    )
    return np.asarray(Image.open(io.BytesIO(content)).convert("RGB")).astype(int)


def body_share(image: "np.ndarray[tuple[int, int, int], np.dtype[np.int64]]") -> float:
    """The part of a picture that is warmer than the bluish background: the clay of the body."""
    return float(((image[..., 0] - image[..., 2]) > 12).mean())


def test_the_body_is_drawn(screen: Screen) -> None:
    image = picture(screen)
    colors = len(np.unique(image.reshape(-1, 3), axis=0))
    assert colors > 300
    assert 0.05 < body_share(image) < 0.5
    assert screen.state()["triangles"] > 192_000


def test_five_views_differ_and_frame_the_body(screen: Screen) -> None:
    seen = {}
    for name in VIEWS:
        screen.get(f"view-{name}").click()
        screen.until("state => !state.moving")
        seen[name] = picture(screen)
        assert 0.02 < body_share(seen[name]) < 0.6, name
    directions = {}
    for number, name in enumerate(VIEWS, start=1):
        # The keys do as the buttons.
        screen.page.keyboard.press(str(number))
        screen.until("state => !state.moving")
        view = screen.state()["view"]
        directions[name] = (round(view["theta"], 2), round(view["phi"], 2))
    assert directions["front"] == (0.0, 1.57)
    assert directions["left"] == (1.57, 1.57)
    assert directions["right"] == (-1.57, 1.57)
    assert abs(directions["back"][0]) == 3.14
    assert directions["top"][1] == 0.0
    for name in VIEWS[1:]:
        assert np.abs(seen[name] - seen["front"]).mean() > 1.0, name


def test_from_the_left_the_front_of_the_body_looks_to_the_left_of_the_page(
    screen: Screen,
) -> None:
    """From the body's own left, its face looks to the left of the page."""
    screen.get("view-left").click()
    bust = screen.state()["landmarks"]
    front = next(one for one in bust if one["name"] == "front neck point")["location"]
    back = next(one for one in bust if one["name"] == "back neck point")["location"]
    places = []
    for patch, u, v in (front, back):
        found = screen.page.evaluate(
            "place => window.bodymeasure.project(...place, {hidden: true})", [patch, u, v]
        )
        places.append(found[0])
    assert places[0] < places[1]


def test_projections(screen: Screen) -> None:
    before = picture(screen)
    screen.get("projection").click()
    assert screen.state()["projection"] == "perspective"
    assert np.abs(picture(screen) - before).mean() > 0.3
    assert 0.05 < body_share(picture(screen)) < 0.5
    screen.page.keyboard.press("o")
    assert screen.state()["projection"] == "orthographic"


def test_dragging_turns_and_the_wheel_zooms(screen: Screen) -> None:
    start = screen.state()["view"]
    place = screen.spot(screen.seen()[10])
    assert place is not None
    screen.page.mouse.move(*place)
    screen.page.mouse.down()
    screen.page.mouse.move(place[0] + 120, place[1], steps=4)
    screen.page.mouse.up()
    turned = screen.state()
    assert abs(turned["view"]["theta"] - start["theta"]) > 0.2
    # A press that moves is no click.
    assert turned["pending"] == 0
    screen.page.mouse.wheel(0, -300)
    screen.until("(state, height) => state.view.height < 0.95 * height", start["height"])
    screen.page.keyboard.press("Home")
    screen.until("(state, height) => Math.abs(state.view.height - height) < 0.2", start["height"])


def test_the_view_is_in_the_address(screen: Screen) -> None:
    screen.page.keyboard.press("3")
    screen.page.keyboard.press("o")
    screen.until("state => !state.moving && location.hash.includes('view=perspective')")
    before = screen.state()["view"]
    screen.page.reload()
    screen.page.wait_for_selector("#bodymeasure[data-ready]")
    screen.until("state => Math.abs(state.view.theta - Math.PI / 2) < 0.001")
    after = screen.state()
    assert after["projection"] == "perspective"
    for name in ("theta", "phi", "height", "target"):
        assert after["view"][name] == pytest.approx(before[name], abs=2e-4)
    # What is no view changes nothing.
    screen.page.evaluate("() => { location.hash = 'view=perspective_1_nan_2_0_0_1e9'; }")
    screen.page.wait_for_timeout(100)
    assert screen.state()["view"] == after["view"]
    # A link that is followed within the page shows its view.
    screen.page.evaluate("() => { location.hash = 'view=orthographic_0_1.5_1.8_0_0.9_0'; }")
    screen.until("state => state.projection === 'orthographic' && state.view.theta === 0")


def test_light_and_dark(open_page: Callable[..., Screen]) -> None:
    dark = open_page(scheme="dark")
    root = dark.page.locator("#bodymeasure")
    assert root.get_attribute("data-theme") == "dark"
    corner = picture(dark)[5, 5]
    assert corner.max() < 80
    dark.get("theme").click()
    assert root.get_attribute("data-theme") == "light"
    assert picture(dark)[5, 5].min() > 180
    # It is remembered in the tab.
    dark.page.reload()
    dark.page.wait_for_selector("#bodymeasure[data-ready]")
    assert root.get_attribute("data-theme") == "light"


@pytest.mark.parametrize("layer", ["seams", "nets", "boundary", "diagonals"])
def test_layers(screen: Screen, layer: str) -> None:
    screen.get("tab-display").click()
    box = screen.get(f"layer-{layer}")
    shown = box.is_checked()
    before = picture(screen)
    geometries = screen.state()["geometries"]
    box.click()
    sign = -1 if shown else 1
    screen.until(
        "(state, [count, sign]) => sign * (state.geometries - count) > 0", [geometries, sign]
    )
    assert np.abs(picture(screen) - before).mean() > 0.05
    if layer == "diagonals":
        assert "Length" in screen.get("legend").inner_text()
        by_length = picture(screen)
        screen.get("lines").select_option("proven")
        assert "not proven" in screen.get("legend").inner_text()
        assert np.abs(picture(screen) - by_length).mean() > 0.02
        screen.get("lines").select_option("length")
    box.click()
    screen.until("(state, count) => state.geometries === count", geometries)


@pytest.mark.parametrize("key", ["gaussian", "mean", "seam_angle"])
def test_colors_by_a_quantity(screen: Screen, key: str) -> None:
    screen.get("tab-display").click()
    before = picture(screen)
    screen.get("color").select_option(key)
    screen.get("legend").wait_for()
    assert np.abs(picture(screen) - before).mean() > 0.05
    if key != "seam_angle":
        # Blue where it is hollow or a saddle, red where it bulges, as the legend has it.
        red, _, blue = np.moveaxis(picture(screen), -1, 0)
        assert (red - blue > 60).sum() > 100
        assert (blue - red > 60).sum() > 100
    words = screen.get("legend").inner_text()
    assert "2 %" in words or "98" in words
    screen.get("color").select_option("none")
    screen.get("legend").wait_for(state="hidden")
    assert np.abs(picture(screen) - before).mean() < 0.05


def test_what_is_under_the_pointer_is_named(screen: Screen) -> None:
    thigh = next(place for place in screen.seen() if place[0] == 173)
    screen.hover(thigh)
    readout = screen.get("readout")
    readout.wait_for()
    assert "thigh right" in readout.inner_text()
    screen.get("tab-display").click()
    screen.get("color").select_option("mean")
    screen.get("legend").wait_for()
    screen.hover(thigh)
    screen.page.wait_for_timeout(100)
    assert "Mean curvature" in readout.inner_text()
    assert "1/m" in readout.inner_text()
    # Off the body there is nothing to name.
    screen.page.mouse.move(30, 500)
    readout.wait_for(state="hidden")


def test_angles_and_curves_are_read_at_the_seam_under_the_pointer(screen: Screen) -> None:
    body = ShownBody("0", bm.load_sample("female_average"), "Average")
    sides = seam_sides(body.atlas).tolist()
    angles, (items, _) = seam_angles(body), _layer(body, "boundary")
    # Middles of sides that can be seen, of which that with the greatest angle is taken.
    fixed = [(edge.fixed_axis, edge.fixed_value) for edge in EDGES]
    middles = [(value, 0.5) if axis == 0 else (0.5, value) for axis, value in fixed]
    seen = [(number, (patch, *middles[side])) for number, (patch, side) in enumerate(sides)]
    middle = angles.shape[1] // 2
    seen = [one for one in seen if screen.spot(one[1]) and not np.isnan(angles[one[0], middle])]
    number, place = max(seen, key=lambda one: float(angles[one[0], middle]))
    angle = angles[number, middle]
    assert angle > 1.0
    screen.get("tab-display").click()
    screen.get("color").select_option("seam_angle")
    screen.get("legend").wait_for()
    screen.get("layer-boundary").click()
    screen.page.keyboard.down("Alt")
    screen.hover(place)
    readout = screen.get("readout")
    readout.get_by_text("Angle at seams").wait_for()
    shown = float(readout.inner_text().split("Angle at seams: ")[1].split()[0])
    # The pointer stands on whole pixels, not exactly in the middle.
    assert shown == pytest.approx(angle, rel=0.1)
    item = items[number]
    curve = readout.get_by_text(item["name"], exact=False)
    curve.wait_for()
    assert f"{100 * item['length']:.2f} cm" in curve.inner_text()
    # Away from all seams there is no angle.
    screen.hover((173, 0.5, 0.5))
    curve.wait_for(state="detached")
    assert "Angle" not in readout.inner_text()


def _layer(body: ShownBody, name: Literal["boundary"]) -> tuple[Any, Any]:
    header, arrays = unpacked(layer_message(body, ShowLayer(name=name)))
    return header["items"], arrays


def test_tapes_are_colored_by_what_was_measured(screen: Screen) -> None:
    screen.take_chart()
    screen.get("tab-display").click()
    color = screen.get("row-chart:hip_girth").locator(".swatch")
    before, groups = picture(screen), color.get_attribute("style")
    for key, title in (("length", "Length of tapes"), ("error", "Error estimate of tapes")):
        screen.get("tapes").select_option(key)
        legend = screen.get("legend")
        legend.get_by_text(title).wait_for()
        assert np.abs(picture(screen) - before).mean() > 0.05
        before = picture(screen)
    screen.get("tapes").select_option("length")
    # The list has the colors of the scene: the longest at the dark end, the shortest at the pale.
    style = "element => getComputedStyle(element.querySelector('.swatch')).backgroundColor"
    rows = screen.get("list").locator("tr[data-id]")
    pairs = [
        (float(row.locator(".value").inner_text().split()[0]), row.evaluate(style))
        for row in (rows.nth(number) for number in range(rows.count()))
        if row.locator(".value").inner_text().endswith("cm")
    ]
    assert max(pairs)[1] == "rgb(68, 1, 84)"
    assert min(pairs)[1] == "rgb(216, 226, 25)"
    assert color.get_attribute("style") != groups
    # The difference from the mesh is measured when it is wanted, of tapes that are paths.
    screen.get("tapes").select_option("difference")
    told = screen.get("legend").get_by_text("Difference from the mesh, of tapes")
    told.wait_for(timeout=180_000)
    # They are small, as those of paths only are that are measured in two ways.
    largest = screen.get("legend").locator(".legend-ends span").last.inner_text()
    assert float(largest) < 1e-3

    def gray(key: str) -> bool:
        color = screen.get(f"row-chart:{key}").evaluate(style)
        return len(set(re.findall(r"\d+", color))) == 1

    assert gray("hip_girth")
    assert not gray("shoulder_width")
    screen.get("tapes").select_option("length")
    # A color of the body and one of the tapes are told side by side.
    screen.get("color").select_option("mean")
    screen.get("legend").get_by_text("Mean curvature").wait_for()
    assert "Length of tapes" in screen.get("legend").inner_text()
    screen.get("color").select_option("none")
    screen.get("tapes").select_option("group")
    screen.get("legend").wait_for(state="hidden")


def test_moving_quality(screen: Screen) -> None:
    """While the view turns, drawing in software is coarser; at rest it is whole again."""
    assert screen.state()["software"]
    whole = screen.state()["triangles"]
    place = screen.spot(screen.seen()[10])
    assert place is not None
    screen.page.mouse.move(*place)
    screen.page.mouse.down()
    # It is coarse for some tenths of a second, which a busy machine may sleep through.
    coarse = None
    while coarse is None:
        screen.page.mouse.move(place[0] + 40, place[1], steps=3)
        screen.page.mouse.move(place[0], place[1], steps=3)
        state = screen.state()
        coarse = state if state["coarse"] and state["triangles"] < 0.5 * whole else None
    assert coarse["ratio"] < 1
    # Elsewhere than where it began, so that it is no click.
    screen.page.mouse.move(place[0] + 40, place[1])
    screen.page.mouse.up()
    screen.until("(state, whole) => !state.coarse && state.triangles === whole", whole)
