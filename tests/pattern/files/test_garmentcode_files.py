"""GarmentCode's specification of a pattern, by the rules by which its program reads them."""

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.polynomial.legendre import leggauss

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.pattern import pattern_garmentcode
from bodymeasure.pattern.files.cubics import cubic_chains, cubic_of


def control(panel: dict[str, Any], edge: dict[str, Any]) -> Array:
    """The control points of an edge, as the program takes them: relative to its chord."""
    start, end = (np.array(panel["vertices"][i]) for i in edge["endpoints"])
    along = end - start
    aside = np.array([-along[1], along[0]])
    params = edge.get("curvature", {"params": [[1 / 3, 0.0], [2 / 3, 0.0]]})["params"]
    return np.array([start, *(start + x * along + y * aside for x, y in params), end])


def points(cubic: Array, count: int = 33) -> Array:
    t = np.linspace(0.0, 1.0, count)[:, None]
    s = 1.0 - t
    inner = 3 * s**2 * t * cubic[1] + 3 * s * t**2 * cubic[2]
    return np.asarray(s**3 * cubic[0] + inner + t**3 * cubic[3])


def length(cubic: Array) -> float:
    nodes, weights = leggauss(40)
    t = (0.5 + 0.5 * nodes)[:, None]
    a, b, c = 3.0 * np.diff(cubic, axis=0)
    speed = (1 - t) ** 2 * a + 2 * t * (1 - t) * b + t**2 * c
    return float(0.5 * weights @ np.linalg.norm(speed, axis=1))


def check_rules(specification: dict[str, Any], eased: set[float] | None = None) -> None:
    """What the program needs in order to read a specification, to mesh it and to sew it."""
    pattern, properties = specification["pattern"], specification["properties"]
    assert properties == {
        "curvature_coords": "relative",
        "normalize_panel_translation": False,
        "normalized_edge_loops": True,
        "units_in_meter": 100,
    }
    assert specification["parameters"] == {}
    assert specification["parameter_order"] == []
    assert pattern["panel_order"] == [*pattern["panels"]]
    for panel in pattern["panels"].values():
        assert len(panel["translation"]) == len(panel["rotation"]) == 3
        count = len(panel["vertices"])
        # One loop of edges, from the vertex nearest to the lower left corner, counterclockwise.
        ends = [edge["endpoints"] for edge in panel["edges"]]
        assert ends == [[i, (i + 1) % count] for i in range(count)]
        vertices = np.array(panel["vertices"])
        from_corner = np.linalg.norm(vertices - vertices.min(axis=0), axis=1)
        assert from_corner.argmin() == 0
        for edge in panel["edges"]:
            curvature = edge.get("curvature")
            if curvature is not None:
                assert curvature["type"] == "cubic"
                assert np.shape(curvature["params"]) == (2, 2)
        ring = np.concatenate([points(control(panel, edge))[:-1] for edge in panel["edges"]])
        assert shapely.is_valid(shapely.polygons(ring))
        assert shapely.is_ccw(shapely.linearrings(ring))
        # The program tells vertices apart by equality.
        assert len(np.unique(vertices, axis=0)) == count
    used = [(side["panel"], side["edge"]) for stitch in pattern["stitches"] for side in stitch]
    # Each edge is sewn once.
    assert len(set(used)) == len(used)
    for name, edge in used:
        assert 0 <= edge < len(pattern["panels"][name]["edges"])
    for one, other in pattern["stitches"]:
        sizes = [
            length(control(panel, panel["edges"][side["edge"]]))
            for side in (one, other)
            for panel in [pattern["panels"][side["panel"]]]
        ]
        # In centimeters: a hundredth of a millimeter. What is eased into a seam is spread evenly.
        ratios = (1.0, *(eased or ()))
        assert any(sizes[1] == pytest.approx(ratio * sizes[0], abs=0.001) for ratio in ratios)


def test_a_bodice_is_sewn_all_round(bodice: bm.Pattern) -> None:
    specification = json.loads(pattern_garmentcode(bodice))
    check_rules(specification)
    pattern = specification["pattern"]
    assert [*pattern["panels"]] == ["bodice_front", "bodice_back"]
    length_of: dict[frozenset[str], float] = {}
    for one, other in pattern["stitches"]:
        panel = pattern["panels"][one["panel"]]
        key = frozenset((one["panel"], other["panel"]))
        size = length(control(panel, panel["edges"][one["edge"]]))
        length_of[key] = length_of.get(key, 0.0) + size
    # Both sides and shoulders, and both darts.
    front = bodice["bodice front"]
    sewn = 2.0 * sum(100.0 * seam.lengths[0] for seam in bodice.seams)
    assert length_of[frozenset(pattern["panels"])] == pytest.approx(sewn, abs=0.001)
    dart = 200.0 * front.darts[0].length
    assert length_of[frozenset(["bodice_front"])] == pytest.approx(dart, abs=0.001)


def test_what_is_sewn_meets_on_the_body(bodice: bm.Pattern) -> None:
    """An edge ends where the one that it is sewn to begins; panels stand before their places."""
    pattern = json.loads(pattern_garmentcode(bodice))["pattern"]
    gaps = []
    for stitch in pattern["stitches"]:
        (a, b), (c, d) = (placed(pattern["panels"][side["panel"]], side["edge"]) for side in stitch)
        gaps.append(np.linalg.norm(a - d) + np.linalg.norm(b - c))
        assert gaps[-1] <= np.linalg.norm(a - c) + np.linalg.norm(b - d) + 1e-9
    assert 0.0 < max(gaps) < 80.0
    front, back = (pattern["panels"][f"bodice_{name}"]["translation"] for name in ("front", "back"))
    assert front[2] > 10.0 > back[2]


def placed(panel: dict[str, Any], edge: int) -> Array:
    """Both ends of an edge in space, by the program's turns about x, y and z in turn."""
    ends = [panel["vertices"][i] for i in panel["edges"][edge]["endpoints"]]
    x, y, z = np.radians(panel["rotation"])
    about_x = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    about_y = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
    about_z = np.array([[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]])
    turn = about_z @ about_y @ about_x
    return np.asarray(np.pad(ends, ((0, 0), (0, 1))) @ turn.T + panel["translation"])


def arc(radius: float, angle: float, count: int) -> Array:
    """A circular arc by its points, as a chain."""
    t = np.linspace(0.0, angle, count)
    return radius * np.stack([np.cos(t), np.sin(t)], axis=1)


def test_a_cubic_is_as_long_as_its_chain() -> None:
    chain = arc(100.0, 1.2, 20)
    cubic = cubic_of(chain)
    assert cubic is not None
    size = np.linalg.norm(np.diff(chain, axis=0), axis=1).sum()
    assert length(cubic) == pytest.approx(size, abs=1e-9)
    assert np.linalg.norm(points(cubic), axis=1) == pytest.approx(100.0, abs=0.1)
    straight = cubic_of(np.array([[0.0, 0.0], [1.0, 2.0], [2.0, 4.0]]))
    assert straight is not None
    assert length(straight) == pytest.approx(np.sqrt(20.0))


def test_both_sides_of_a_seam_are_cut_alike() -> None:
    sides = [arc(100.0, 3.0, 60), arc(300.0, 1.0, 40)]
    sides[1] *= (
        np.linalg.norm(np.diff(sides[0], axis=0), axis=1).sum()
        / np.linalg.norm(np.diff(sides[1], axis=0), axis=1).sum()
    )
    one, other = cubic_chains(sides, (0.0, 0.3, 1.0))
    assert len(one) == len(other) >= 3
    assert [length(cubic) for cubic in one] == pytest.approx([length(cubic) for cubic in other])
    for cubics in (one, other):
        for before, after in pairwise(cubics):
            assert before[-1] == pytest.approx(after[0])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "key", "panels"),
    [
        ("female_average", "princess", 4),
        ("female_old", "skirt", 2),
        ("female_average", "sleeve", 4),
        ("male_average", "trousers", 4),
    ],
)
def test_other_sets(name: str, key: str, panels: int) -> None:
    made = bm.make_pattern(bm.load_sample(name), key)
    specification = json.loads(pattern_garmentcode(made))
    check_rules(specification, {seam.lengths[1] / seam.lengths[0] for seam in made.seams})
    assert len(specification["pattern"]["panels"]) == panels
    sewn = {frozenset(side["panel"] for side in s) for s in specification["pattern"]["stitches"]}
    # All panels hang together.
    connected = {specification["pattern"]["panel_order"][0]}
    for _ in range(panels):
        connected |= {name for pair in sewn if pair & connected for name in pair}
    # The skirt's halves are sewn at the sides, the waist is sewn to nothing.
    assert connected == set(specification["pattern"]["panels"])


@pytest.mark.slow
def test_center_seams_are_sewn_to_their_mirror_images() -> None:
    made = bm.make_pattern(bm.load_sample("male_average"), "trousers")
    stitches = json.loads(pattern_garmentcode(made))["pattern"]["stitches"]
    pairs = {frozenset(side["panel"] for side in stitch) for stitch in stitches}
    assert frozenset(("trousers_front", "trousers_front_mirrored")) in pairs
    assert frozenset(("trousers_back", "trousers_back_mirrored")) in pairs
