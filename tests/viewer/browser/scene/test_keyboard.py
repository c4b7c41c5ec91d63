"""Everything by keyboard alone."""

from helpers.viewer_page import Screen


def focused(screen: Screen) -> str:
    text: str = screen.page.evaluate(
        "() => document.activeElement.dataset.testid ?? document.activeElement.className"
    )
    return text


def focus_scene(screen: Screen) -> None:
    """Go to the scene as who has no mouse does."""
    for _ in range(40):
        screen.page.keyboard.press("Tab")
        if focused(screen) == "scene":
            return
    raise AssertionError("the scene cannot be reached by Tab")


def test_a_tape_with_the_crosshair(screen: Screen) -> None:
    focus_scene(screen)
    assert screen.get("crosshair").is_visible()
    press = screen.page.keyboard.press
    press("Enter")
    screen.until("state => state.pending === 1")
    for _ in range(14):
        press("w")
    press("Enter")
    screen.until("state => state.tapes.length === 1")
    tape = screen.settle()["tapes"][0]
    assert tape["result"]["length"] > 0.05
    # Its ends are reached and moved by keys as well.
    screen.get(f"handle-{tape['id']}-1").focus()
    press("ArrowUp")
    moved = screen.settle()["tapes"][0]
    assert moved["locations"][1] != tape["locations"][1]
    press("Control+z")
    assert screen.settle()["tapes"][0]["locations"] == tape["locations"]


def test_arrows_turn_and_plus_zooms(screen: Screen) -> None:
    focus_scene(screen)
    press = screen.page.keyboard.press
    start = screen.state()["view"]
    press("ArrowRight")
    press("ArrowUp")
    turned = screen.state()["view"]
    assert turned["theta"] > start["theta"]
    assert turned["phi"] < start["phi"]
    press("+")
    assert screen.state()["view"]["height"] < turned["height"]
    press("Shift+ArrowLeft")
    assert screen.state()["view"]["target"] != turned["target"]
    press("Home")
    press("1")
    screen.until("state => Math.abs(state.view.theta) < 1e-6")


def test_tools_and_escape(screen: Screen) -> None:
    for key, name in (
        ("v", "look"),
        ("g", "girth"),
        ("l", "loop"),
        ("m", "landmark"),
        ("t", "tape"),
    ):
        screen.page.keyboard.press(key)
        assert screen.state()["tool"] == name
        assert screen.get(f"tool-{name}").get_attribute("aria-pressed") == "true"
        assert screen.get("hint").inner_text()
    screen.page.keyboard.press("Escape")
    assert screen.state()["tool"] == "look"


def test_letters_that_are_typed_do_nothing_else(screen: Screen) -> None:
    screen.page.keyboard.press("/")
    assert focused(screen) == "search"
    screen.page.keyboard.type("girth of mvt 12345")
    assert screen.state()["tool"] == "tape"
    assert abs(screen.state()["view"]["theta"]) < 1e-9


def test_the_list_by_arrows(screen: Screen) -> None:
    screen.take_chart()
    rows = screen.get("list").locator(".row-name")
    rows.first.focus()
    press = screen.page.keyboard.press
    press("ArrowDown")
    press("ArrowDown")
    third = rows.nth(2).get_attribute("data-row")
    screen.until("(state, row) => state.lit === row", third)
    press("Enter")
    screen.until("(state, row) => state.selected === row", third)
    press(" ")
    assert screen.page.locator(f'tr.off[data-id="{third}"]').count() == 1
    press("End")
    assert focused(screen).startswith("row-name")
    press("f")
    press("?")
    dialog = screen.page.get_by_role("dialog")
    dialog.wait_for()
    assert "Home" in dialog.inner_text()
    press("Escape")
    dialog.wait_for(state="detached")


def test_menus_and_tabs(screen: Screen) -> None:
    press = screen.page.keyboard.press
    screen.get("more").focus()
    press("Enter")
    assert focused(screen) == "menu-open"
    # Bodies that other tests have opened on the same server stand in the menu, too.
    for _ in range(screen.page.locator("[data-testid^=menu-body-]").count()):
        press("ArrowDown")
    press("ArrowDown")
    assert focused(screen) == "menu-between"
    press("Escape")
    assert focused(screen) == "more"
    screen.get("tab-list").focus()
    press("ArrowRight")
    assert focused(screen) == "tab-landmarks"
    assert screen.get("landmarks").is_visible()


def test_focus_is_seen(screen: Screen) -> None:
    """Each of the first stops of Tab has an outline."""
    for _ in range(14):
        screen.page.keyboard.press("Tab")
        style = screen.page.evaluate(
            "() => getComputedStyle(document.activeElement).outlineStyle + ' '"
            " + getComputedStyle(document.activeElement).outlineWidth"
        )
        assert style == "solid 2px", focused(screen)
