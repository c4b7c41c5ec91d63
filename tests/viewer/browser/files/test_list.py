"""The list is one with the scene: searched, sorted, flown from, copied and saved in every unit."""

import csv
import io
import json
from xml.etree import ElementTree

import pytest
from helpers.viewer_page import Screen, saved

import bodymeasure as bm


@pytest.fixture
def chart(screen: Screen) -> Screen:
    screen.take_chart()
    return screen


def rows(screen: Screen) -> list[str]:
    return screen.get("list").locator("tr[data-id] .row-name").all_inner_texts()


def values(screen: Screen) -> list[float]:
    texts = screen.get("list").locator("tr[data-id] .value").all_inner_texts()
    return [float(text.split()[0]) for text in texts if text.endswith("cm")]


def test_the_chart_is_the_librarys(chart: Screen) -> None:
    measured = bm.measure_chart(bm.load_sample("female_average"), only=("core",))
    assert chart.state()["chart"] == len(measured.measured)
    expected = {item.definition.key: item.value for item in measured.measured}
    for key in ("bust_girth", "waist_girth", "back_neck_to_waist"):
        shown = chart.get(f"row-chart:{key}").locator(".value").inner_text()
        assert shown == f"{100 * expected[key]:.2f} cm"


def test_search_by_name_code_and_landmark(chart: Screen) -> None:
    every = len(rows(chart))
    chart.page.keyboard.press("/")
    search = chart.get("search")
    search.fill("waist girth")
    found = rows(chart)
    assert 1 <= len(found) < 10
    assert "Waist girth" in found
    assert f"{len(found)} of {every}" in chart.get("count").inner_text()
    search.fill("5.3.10")
    assert 1 <= len(rows(chart)) < 20
    search.fill("crotch point")
    assert rows(chart)
    search.fill("nothing is called so")
    assert not rows(chart)
    search.press("Escape")
    assert len(rows(chart)) == every


def test_sorted_by_name_and_value(chart: Screen) -> None:
    grouped = rows(chart)
    chart.get("sort-value").click()
    falling = values(chart)
    assert falling == sorted(falling, reverse=True)
    chart.get("sort-value").click()
    assert values(chart) == sorted(falling)
    chart.get("sort-value").click()
    assert rows(chart) == grouped
    chart.get("sort-name").click()
    names = [name.lower() for name in rows(chart)]
    assert names == sorted(names)
    assert chart.page.locator("th[aria-sort=ascending]").count() == 1


def test_row_and_scene_are_one(chart: Screen) -> None:
    row = chart.get("row-chart:bust_girth")
    row.hover()
    chart.until("state => state.lit === 'chart:bust_girth'")
    chart.get("label-chart:bust_girth").wait_for()
    before = chart.state()["view"]
    row.locator(".value").click()
    state = chart.until("state => state.selected === 'chart:bust_girth' && !state.moving && state")
    assert state["view"]["height"] < 0.8 * before["height"]
    assert "bust" in chart.get("details").inner_text().lower()

    # The other way round: what is under the pointer glows in the list, and a click selects it.
    chart.page.keyboard.press("Escape")
    chart.get("tool-look").click()
    chart.page.keyboard.press("1")
    chart.page.mouse.move(5, 300)
    chart.until("state => !state.moving && state.lit === null")
    box = chart.page.locator("canvas").bounding_box()
    assert box is not None
    found = chart.page.evaluate(
        "() => { const s = window.bodymeasure.state().landmarks;"
        " return s.find((one) => one.name === 'bust point left').location; }"
    )
    place = chart.spot(found)
    assert place is not None
    chart.page.mouse.move(place[0] - 25, place[1])
    lit = chart.until("state => state.lit")
    assert chart.page.locator("tr.lit").get_attribute("data-id") == lit
    chart.page.mouse.click(place[0] - 25, place[1])
    chart.until("(state, lit) => state.selected === lit", lit)


def test_hidden_and_shown(chart: Screen) -> None:
    assert "chart:bust_girth/0" in chart.state()["lines"]
    row = chart.get("row-chart:bust_girth")
    row.hover()
    row.get_by_role("button", name="Hide").click()
    chart.page.mouse.move(300, 450)
    chart.until("state => !state.lines.includes('chart:bust_girth/0')")
    chart.get("tab-display").click()
    chart.get("layer-tapes").click()
    chart.until("state => !state.lines.some((line) => line.startsWith('chart:'))")


def test_units_change_everywhere_at_once(chart: Screen) -> None:
    tape = chart.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    length = tape["result"]["length"]
    row = chart.get(f"row-{tape['id']}").locator(".value")
    assert row.inner_text() == f"{100 * length:.2f} cm"
    chart.get("unit").select_option("mm")
    assert row.inner_text() == f"{1000 * length:.1f} mm"
    assert f"{1000 * length:.1f}" in chart.get(f"label-{tape['id']}").inner_text()
    chart.get("unit").select_option("in")
    sixteenths = round(length / 0.0254 * 16)
    whole, rest = divmod(sixteenths, 16)
    shown = chart.get("length").inner_text()
    assert row.inner_text() == shown
    assert shown.startswith(f"{whole}")
    if rest:
        over, under = (int(part) for part in shown.split()[1].split("/"))
        assert over * 16 == rest * under
        assert over % 2 == 1
    # The error is that of the length, not of its nearest sixteenth.
    assert chart.get("error").inner_text().startswith(f"{length / 0.0254:.4f} ±")
    assert "in" in chart.get("row-chart:bust_girth").locator(".value").inner_text()


def test_a_value_and_the_list_are_copied(chart: Screen) -> None:
    tape = chart.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    chart.get("copy").click()
    chart.page.get_by_text("Copied").first.wait_for()
    text = chart.page.evaluate("() => navigator.clipboard.readText()")
    assert float(text) == pytest.approx(100 * tape["result"]["length"], abs=1e-5)
    chart.get("more").click()
    chart.get("menu-copy").click()
    chart.page.get_by_text("rows; paste them").wait_for()
    table = chart.page.evaluate("() => navigator.clipboard.readText()")
    lines = [line.split("\t") for line in table.splitlines()]
    assert lines[0][0] == "name"
    assert {len(line) for line in lines} == {len(lines[0])}
    assert len(lines) == 1 + len(rows(chart))


def test_files(chart: Screen) -> None:
    """Each file has the values of the library, in the unit that is shown."""
    measured = bm.measure_chart(bm.load_sample("female_average"), only=("core",))
    millimeters = 1000 * measured["bust_girth"].value
    chart.get("unit").select_option("mm")

    def file(entry: str, ending: str, *, last: bool = True) -> str:
        chart.get("more").click()
        entries = chart.get(entry)
        which = entries.last if last else entries.first
        name, content = saved(chart, which.click)
        assert name.endswith(ending)
        return content.decode("utf-8-sig")

    by_key = {row["key"]: row for row in csv.DictReader(io.StringIO(file("menu-csv", ".csv")))}
    assert list(by_key) == [item.definition.key for item in measured.measured]
    assert float(by_key["bust_girth"]["value"]) == pytest.approx(millimeters, abs=1e-3)
    assert by_key["bust_girth"]["unit"] == "mm"
    listed = list(csv.reader(io.StringIO(file("menu-csv", ".csv", last=False))))
    assert [row[0] for row in listed[1:]] == rows(chart)
    (row,) = [row for row in listed if row[0] == "Bust girth"]
    assert (row[3], listed[0][3]) == (f"{millimeters:.6f}", "value (mm, or degrees)")
    # However small an error is, it is not 0.
    assert float(row[4]) == pytest.approx(1000 * measured["bust_girth"].error_estimate, rel=0.05)
    document = json.loads(file("menu-json", ".json"))
    assert document["unit"] == "mm"
    (one,) = [one for one in document["measurements"] if one["key"] == "bust_girth"]
    assert one["value"] == pytest.approx(millimeters, rel=1e-12)
    (circ,) = [
        element
        for element in ElementTree.fromstring(file("menu-smis", ".smis")).iter("m")
        if element.get("name") == "bust_circ"
    ]
    assert float(circ.get("value", "")) == pytest.approx(millimeters, abs=0.1)
    sewing = json.loads(file("menu-freesewing", ".json"))
    assert str(round(millimeters, 1)).split(".")[0] in json.dumps(sewing)


def test_tapes_are_saved_and_opened_again(chart: Screen) -> None:
    tape = chart.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    chart.get("more").click()
    name, content = saved(chart, lambda: chart.get("menu-tapes").click())
    chart.get("delete").click()
    assert not chart.state()["tapes"]
    chart.drop(name, content)
    chart.until("state => state.tapes.length === 1")
    again = chart.settle()["tapes"][0]
    assert again["locations"] == tape["locations"]
    assert again["result"]["length"] == tape["result"]["length"]


def test_a_picture_is_saved(chart: Screen) -> None:
    chart.get("more").click()
    name, content = saved(chart, lambda: chart.get("menu-picture").click())
    assert name.endswith(".png")
    from PIL import Image

    image = Image.open(io.BytesIO(content)).convert("RGB")
    canvas = chart.page.locator("canvas").bounding_box()
    assert canvas is not None
    # Twice as many pixels as on the screen, and not empty.
    assert image.width == pytest.approx(2 * canvas["width"], abs=2)
    colors = image.getcolors(maxcolors=16_777_216)
    assert colors is not None
    assert len(colors) > 300


@pytest.mark.parametrize("name", ["-1+1", "+1", "=1+1", "@sum", "-name"])
def test_no_name_is_a_formula(screen: Screen, name: str) -> None:
    tape = {
        "name": name,
        "mode": "path",
        "kind": "contact",
        "locations": [[15, 0.5, 0.5], [173, 0.5, 0.5]],
    }
    content = {"format": "bodymeasure tapes", "version": 1, "tapes": [tape]}
    screen.drop("mine.tapes.json", json.dumps(content).encode())
    screen.settle()
    screen.get("more").click()
    _, saved_list = saved(screen, lambda: screen.get("menu-csv").last.click())
    _, row = csv.reader(io.StringIO(saved_list.decode("utf-8-sig")))
    assert row[0] == f"'{name}"
    assert float(row[3]) > 10.0


def test_a_full_memory_costs_no_setting(screen: Screen) -> None:
    tape = screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    screen.page.evaluate(
        "() => { Storage.prototype.setItem = () => { throw new DOMException('full'); }; }"
    )
    screen.get("unit").select_option("mm")
    length = 1000 * tape["result"]["length"]
    shown = screen.get(f"row-{tape['id']}").locator(".value").inner_text()
    assert shown == f"{length:.1f} mm"
