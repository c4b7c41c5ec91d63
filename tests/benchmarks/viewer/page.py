"""What the page costs in Chromium: the first picture, a frame while it moves, rest, and memory.

    python tests/benchmarks/viewer/page.py

All times are processor time of Chromium's processes (of the server's, too, for the first picture),
so that other work on the machine counts little. Drawing is in software, the slowest there is.
"""

import json
import shutil
import sys
import time
from pathlib import Path

import numpy as np
import psutil
from playwright.sync_api import Browser, sync_playwright

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.viewer_page import Screen, serve

ROUNDS = 3
TURNS = 60
TAPES, STAY = 200, 10
IDLE = 10.0
ARGUMENTS = ("--no-sandbox", "--enable-unsafe-swiftshader", "--no-first-run")


def chromium_time() -> float:
    """Return the processor time of all processes of the browser, also of those that ended."""
    every = psutil.Process().children(recursive=True)
    own = [one for one in every if "chrom" in one.name()]
    return float(sum(sum(one.cpu_times()) for one in own))


def page_of(browser: Browser) -> Screen:
    context = browser.new_context(viewport={"width": 1400, "height": 900})
    return Screen.on(context.new_page())


def first_picture(browser: Browser) -> None:
    """Print the processor time from the command to the first picture."""
    times = []
    for _ in range(ROUNDS):
        before = chromium_time()
        served = serve("female_average")
        screen = page_of(browser).open(served.link)
        process = psutil.Process(served.process.pid)
        server = sum(
            sum(one.cpu_times()[:2]) for one in (process, *process.children(recursive=True))
        )
        times.append((server, chromium_time() - before))
        screen.page.context.close()
        served.stop()
    server, page = np.median(times, axis=0)
    print(f"command to first picture: {server + page:.2f} s (server {server:.2f}, page {page:.2f})")


def moving_frames(screen: Screen) -> None:
    """Print the processor time of a frame while the body is turned."""
    # Beside the body, where nothing else can be taken hold of.
    place = (100, 500)
    screen.page.mouse.move(*place)
    screen.page.mouse.down()
    screen.page.mouse.move(place[0] + 5, place[1])
    frames, before = screen.state()["frames"], chromium_time()
    for step in range(TURNS):
        screen.page.mouse.move(place[0] + 6 * step, place[1])
        screen.page.wait_for_timeout(40)
    used, drawn = chromium_time() - before, screen.state()["frames"] - frames
    screen.page.mouse.up()
    print(f"a frame while turning: {1000.0 * used / drawn:.0f} ms ({drawn} frames)")


def doing_nothing(screen: Screen) -> None:
    """Print the share of a core that a page at rest takes."""
    screen.page.mouse.move(60, 500)
    screen.page.wait_for_timeout(2000)
    before, begin = chromium_time(), time.monotonic()
    screen.page.wait_for_timeout(IDLE * 1000.0)
    share = (chromium_time() - before) / (time.monotonic() - begin)
    print(f"at rest: {100.0 * share:.2f} % of a core")


def heap(screen: Screen) -> float:
    """Return what the page holds after its garbage is collected, in MB."""
    session = screen.page.context.new_cdp_session(screen.page)
    session.send("HeapProfiler.collectGarbage")
    session.send("Performance.enable")
    metrics = session.send("Performance.getMetrics")["metrics"]
    session.detach()
    return float(next(one["value"] for one in metrics if one["name"] == "JSHeapUsedSize")) / 1e6


def many_tapes(screen: Screen) -> None:
    """Print what the page holds while tapes are measured and deleted, of which 10 stay."""
    random = np.random.default_rng(1)
    held = []
    for number in range(1, TAPES + 1):
        ends = [[int(random.integers(376)), random.random(), random.random()] for _ in range(2)]
        tape = {"name": f"{number}", "mode": "path", "kind": "contact", "locations": ends}
        content = {"format": "bodymeasure tapes", "version": 1, "tapes": [tape]}
        screen.drop("one.tapes.json", json.dumps(content).encode())
        screen.until("(state, name) => state.tapes.some((one) => one.name === name)", f"{number}")
        state = screen.settle()
        if len(state["tapes"]) > STAY:
            screen.get(f"row-{state['tapes'][0]['id']}").locator(".value").click()
            screen.page.keyboard.press("Delete")
            screen.until("(state, most) => state.tapes.length <= most", STAY)
        if number % (TAPES // 5) == 0:
            held.append((number, heap(screen), screen.state()["geometries"]))
    for number, size, geometries in held:
        print(f"after {number} tapes: {size:.1f} MB, {geometries} geometries")


def main() -> None:
    path = shutil.which("chromium")
    assert path is not None, "apt-get install chromium"
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        first_picture(browser)
        served = serve("female_average")
        screen = page_of(browser).open(served.link)
        screen.page.wait_for_timeout(2000)
        moving_frames(screen)
        doing_nothing(screen)
        screen.page.keyboard.press("1")
        screen.until("state => !state.moving && Math.abs(state.view.theta) < 1e-6")
        screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
        screen.take_chart("default")
        screen.page.wait_for_timeout(1500)
        print("with a chart:", end=" ")
        moving_frames(screen)
        print("with a chart,", end=" ")
        doing_nothing(screen)
        many_tapes(page_of(browser).open(served.link))
        browser.close()
        served.stop()


if __name__ == "__main__":
    main()
