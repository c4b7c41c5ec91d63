"""No serious finding of axe-core on any page of the viewer, by day and by night."""

from collections.abc import Callable

import pytest
from helpers.viewer_page import Screen, findings


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe(open_page: Callable[..., Screen], axe: str, scheme: str) -> None:
    screen = open_page(scheme=scheme)
    assert not findings(screen, axe)
    screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    screen.take_chart()
    screen.get("row-chart:bust_girth").locator(".value").click()
    assert not findings(screen, axe)
    screen.get("tab-landmarks").click()
    screen.get("landmarks").get_by_text("crotch point").click()
    assert not findings(screen, axe)
    screen.get("tab-display").click()
    screen.get("layer-names").click()
    screen.get("color").select_option("gaussian")
    screen.get("legend").wait_for()
    assert not findings(screen, axe)
    screen.get("more").click()
    assert not findings(screen, axe)
    screen.page.keyboard.press("Escape")
    screen.page.keyboard.press("?")
    assert not findings(screen, axe)


def test_less_motion(screen: Screen) -> None:
    """Who asked for less motion gets no flight: the view is there at once."""
    screen.page.keyboard.press("2")
    assert abs(abs(screen.state()["view"]["theta"]) - 3.1416) < 1e-3
    durations = screen.page.evaluate(
        "() => [...document.querySelectorAll('#bodymeasure *')].map((element) =>"
        " parseFloat(getComputedStyle(element).animationDuration))"
    )
    assert max(durations) <= 0.001


def test_motion(open_page: Callable[..., Screen]) -> None:
    screen = open_page()
    screen.page.emulate_media(reduced_motion="no-preference")
    screen.page.keyboard.press("2")
    # On the way, not there at once.
    assert abs(screen.state()["view"]["theta"]) < 3.0
    screen.until("state => Math.abs(Math.abs(state.view.theta) - Math.PI) < 1e-6")
