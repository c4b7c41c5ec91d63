"""Cut lines and notches, on shapes whose allowances are known."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest
import shapely

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.pattern.files.allowance import widened
from bodymeasure.pattern.files.drawn import DrawnPiece, drawn_piece

SQUARE = np.array([[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]])
# A right angle that points inwards, at its third corner.
HOOK = np.array([[0.0, 0], [100, 0], [100, 50], [50, 50], [50, 100], [0, 100]])


def bounds(ring: Array, allowance: list[float]) -> list[float]:
    return shapely.bounds(widened(ring, np.array(allowance))).round(9).tolist()  # type: ignore[no-any-return]


def test_each_side_has_its_own_allowance() -> None:
    area = widened(SQUARE, np.array([40.0, 10.0, 5.0, 0.0]))
    assert area.equals(shapely.box(0.0, -40.0, 110.0, 105.0))


def test_a_corner_that_points_inwards_stays_one() -> None:
    area = widened(HOOK, np.array([10.0] * 6))
    assert area.area == pytest.approx(120.0 * 70.0 + 70.0 * 50.0)
    uneven = widened(HOOK, np.array([0.0, 0.0, 10.0, 20.0, 0.0, 0.0]))
    assert uneven.area == pytest.approx(7500.0 + 20.0 * 50.0 + 10.0 * 50.0 - 10.0 * 20.0)


def test_sharp_corners_are_cut_off() -> None:
    spike = np.array([[0.0, 0.0], [300.0, -15.0], [300.0, 15.0]])
    tip = 300.0 / 15.0 * 10.0
    assert bounds(spike, [10.0] * 3)[0] > -30.0 > -tip


def test_the_wider_of_two_sides_ends_at_the_narrower_one() -> None:
    # The lower corners of a trapezoid are blunt: a wide hem must not stick out beside the seam.
    ring = np.array([[0.0, 0.0], [100.0, 0.0], [150.0, 100.0], [-50.0, 100.0]])
    area = widened(ring, np.array([40.0, 10.0, 10.0, 10.0]))
    slope = shapely.LineString([(100.0, 0.0), (80.0, -40.0)])
    normal = np.array([2.0, -1.0]) / np.sqrt(5.0)
    corners = shapely.get_coordinates(area)
    beyond = (corners - [100.0, 0.0]) @ normal
    assert beyond.max() == pytest.approx(10.0)
    assert area.contains(slope)


def test_nothing_lies_beyond_a_fold() -> None:
    # The lower side nearly runs on from the fold, so that its allowance would reach over it.
    ring = np.array([[0.0, 0.0], [30.0, -90.0], [100.0, -90.0], [100.0, 100.0], [0.0, 100.0]])
    allowance = np.array([10.0, 10.0, 10.0, 10.0, 0.0])
    fold = np.array([[0.0, 100.0], [0.0, 0.0]])
    assert bounds(ring, allowance.tolist())[0] < -5.0
    assert shapely.bounds(widened(ring, allowance, fold))[0] == pytest.approx(0.0, abs=1e-9)


def changed(pattern: bm.Pattern, name: str, **members: object) -> bm.Pattern:
    """A pattern with other members of a panel."""
    pieces = tuple(
        replace(piece, panel=msgspec.structs.replace(piece.panel, **members))
        if piece.name == name
        else piece
        for piece in pattern.pieces
    )
    return replace(pattern, pieces=pieces)


def drawn(pattern: bm.Pattern, name: str, **members: object) -> DrawnPiece:
    """A piece of a pattern, with other members of its panel."""
    other = changed(pattern, name, **members)
    return drawn_piece(other, other[name], 10.0, "")


def away(piece: DrawnPiece, name: str) -> Array:
    """The distances of an edge from the cut line, but near its ends."""
    (chain,) = next(edge.parts for edge in piece.edges if edge.name == name)
    ring = shapely.linearrings(piece.cut)
    return np.asarray(shapely.distance(ring, shapely.points(chain[8:-8])))


def test_allowances_of_edges_and_panels(bodice: bm.Pattern) -> None:
    back = bodice["bodice back"].panel
    edges = tuple(
        msgspec.structs.replace(edge, allowance=0.025) if edge.name == "side" else edge
        for edge in back.edge
    )
    piece = drawn(bodice, "bodice back", edge=edges, allowance=0.006)
    # In a hollow a corner of the sew line is farther away than its sides.
    assert away(piece, "side") == pytest.approx(25.0, abs=0.02)
    assert away(piece, "shoulder") == pytest.approx(6.0, abs=0.02)
    assert away(piece, "center back") == pytest.approx(0.0, abs=1e-6)


def notched(piece: DrawnPiece, name: str) -> Array:
    """The lengths along an edge, from its end with the larger y, at which it is notched."""
    (chain,) = next(edge.parts for edge in piece.edges if edge.name == name)
    line = shapely.linestrings(chain if chain[0, 1] > chain[-1, 1] else chain[::-1])
    places = [notch.sewn for notch in piece.notches if notch.edge == name]
    return np.sort([shapely.line_locate_point(line, shapely.points(place)) for place in places])


def test_both_sides_of_a_seam_are_notched_at_the_same_lengths(bodice: bm.Pattern) -> None:
    edges = tuple(
        msgspec.structs.replace(edge, notches=(0.2, 0.7)) if edge.name == "side" else edge
        for edge in bodice["bodice front"].panel.edge
    )
    pattern = changed(bodice, "bodice front", edge=edges)
    front, back = (drawn_piece(pattern, piece, 10.0, "") for piece in pattern.pieces)
    single, double = notched(front, "side"), notched(back, "side")
    length = 1000.0 * bodice["bodice front"].edge("side").length
    assert single == pytest.approx([0.2 * length, 0.7 * length], abs=1e-6)
    assert double.reshape(2, 2).mean(axis=1) == pytest.approx(single, abs=1e-6)


def test_notches_stay_in_the_allowance_and_darts_are_marked(bodice: bm.Pattern) -> None:
    piece = drawn(bodice, "bodice front")
    ring, sewn = shapely.linearrings(piece.cut), piece.inner
    for notch in piece.notches:
        assert shapely.distance(ring, shapely.points(notch.line[0])) < 1e-6
        assert shapely.distance(sewn, shapely.linestrings(notch.line)) > 3.0
        assert np.linalg.norm(notch.line[0] - notch.sewn) == pytest.approx(10.0, abs=1.5)
    (dart,) = piece.darts
    feet = [leg[0] for leg in dart.legs]
    marked = [notch.sewn for notch in piece.notches if notch.edge == "waist"]
    assert np.abs(np.sort(feet, axis=0) - np.sort(marked, axis=0)).max() < 1e-6
    assert np.linalg.norm(dart.hole - dart.legs[0][-1]) == pytest.approx(10.0)


def test_the_mouth_of_a_dart_has_a_cap_that_its_fold_needs(bodice: bm.Pattern) -> None:
    piece = drawn(bodice, "bodice front")
    (dart,) = piece.darts
    tip, feet = dart.legs[0][-1], np.stack([leg[0] for leg in dart.legs])
    middle = feet.mean(axis=0) - tip
    reach = float(np.linalg.norm(middle))
    ray = shapely.linestrings([tip, tip + 1.5 * middle])
    (top,) = shapely.get_coordinates(shapely.intersection(shapely.linearrings(piece.cut), ray))
    # Folded to one side, the middle of the dart lies on the waist beside that leg or beyond it.
    (waist,) = (edge for edge in piece.edges if edge.name == "waist")
    line = shapely.linestrings(waist.parts[0])
    foot = feet[np.linalg.norm(feet - waist.parts[0][-1], axis=1).argmin()]
    leg = (foot - tip) / np.linalg.norm(foot - tip)
    folded = 2.0 * ((top - tip) @ leg) * leg - (top - tip) + tip
    assert shapely.distance(line, shapely.points(folded)) == pytest.approx(10.0, abs=1.5)
    assert np.linalg.norm(top - tip) > reach + 12.0


@pytest.mark.parametrize("noise", [0.0, 1e-12, 1e-9, 1e-7])
def test_straight_sides_of_many_points_have_smooth_cut_lines(noise: float) -> None:
    # Strips along sides that turn by rounding leave cracks between them, down to the sew line.
    random = np.random.default_rng(0)
    corners = np.array([[0.0, 0.0], [310.0, 130.0], [170.0, 560.0], [-40.0, 390.0]])
    ways = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    ring = np.concatenate([a + (b - a) * np.arange(57)[:, None] / 57 for a, b in ways])
    ring += noise * random.normal(size=ring.shape)
    area = widened(ring, np.full(len(ring), 10.0))
    assert shapely.distance(area.exterior, shapely.points(ring)).min() == pytest.approx(10.0)
    assert area.symmetric_difference(widened(corners, np.full(4, 10.0))).area < 1e-2
    assert len(area.exterior.coords) < 20


def test_a_fold_that_rounding_leaves_not_quite_straight_keeps_its_piece() -> None:
    rng = np.random.default_rng(0)
    down = np.linspace(561.2481593942016, 0.0, 20)
    for _ in range(30):
        fold = np.stack([1e-20 * rng.normal(size=6), down[[-1, 15, 11, 8, 4, 0]]], axis=1)
        outer = np.stack([-200.0 - 30.0 * np.sin(down / 200.0) - rng.random(20), down], axis=1)
        ring = np.concatenate([fold, outer])
        area = widened(ring, np.zeros(len(ring)), fold[[0, -1]])
        assert shapely.area(area) == pytest.approx(shapely.area(shapely.polygons(ring)), abs=1e-3)
