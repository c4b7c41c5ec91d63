"""The length shown is the library's, to every digit that is shown."""

import re
from collections.abc import Callable, Iterator

import numpy as np
import pytest
from helpers.viewer_page import Screen, Served, serve

import bodymeasure as bm

PAIRS = 20
BODIES = ("female_average", "male_average", "female_heavy")


@pytest.fixture(scope="module", params=BODIES)
def other(request: pytest.FixtureRequest) -> Iterator[tuple[str, Served]]:
    served = serve(request.param)
    yield request.param, served
    served.stop()


def test_random_pairs(
    other: tuple[str, Served], open_page: Callable[..., Screen], rng: np.random.Generator
) -> None:
    name, served = other
    atlas = bm.load_sample(name)
    screen = open_page(served.link, size=(1024, 700))
    failures = 0
    for _ in range(PAIRS):
        known = _visible_pair(screen, rng, len(atlas))
        # Snapping would move an end by pixels, which are centimeters where the skin is oblique.
        screen.page.keyboard.down("Alt")
        tape = screen.measure(*known)
        screen.page.keyboard.up("Alt")
        ends = [_place(atlas, location) for location in tape["locations"]]
        for end, place in zip(ends, known, strict=True):
            # Where the click was, up to half a pixel.
            apart = np.linalg.norm(atlas.position(end) - atlas.position(bm.AtlasPoint(*place)))
            assert apart < 0.02
        path = bm.geodesic_between(atlas, ends[0], ends[1], on_failure="status")
        shown = screen.get("length").inner_text()
        if not np.isfinite(path.length):
            failures += 1
            assert shown == "No length"
            assert screen.get("words").inner_text()
            continue
        match = re.fullmatch(r"(\d+\.(\d{2,6})) cm", shown)
        assert match, shown
        assert match[1] == f"{100.0 * path.length:.{len(match[2])}f}"
        assert tape["result"]["length"] == path.length
    assert failures < PAIRS / 2


def _visible_pair(
    screen: Screen, rng: np.random.Generator, patches: int
) -> list[tuple[int, float, float]]:
    """Two random points of a body that can be seen, at least 30 pixels apart."""
    pair: list[tuple[int, float, float]] = []
    while len(pair) < 2:
        u, v = rng.uniform(0.02, 0.98, 2).tolist()
        place = (int(rng.integers(patches)), u, v)
        spot = screen.spot(place)
        if spot is None:
            continue
        if pair:
            first = screen.spot(pair[0])
            assert first is not None
            if np.hypot(spot[0] - first[0], spot[1] - first[1]) < 30.0:
                continue
        pair.append(place)
    return pair


def _place(atlas: bm.Atlas, location: str | list[float]) -> bm.AtlasPoint:
    if isinstance(location, str):
        return atlas.landmarks[location]
    return bm.AtlasPoint(int(location[0]), location[1], location[2])
