"""The landmarks that rules derive, on surfaces where their positions are known."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import wavy_plane
from helpers.surfaces.tubes import QUARTER, joined, tube

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Axes
from bodymeasure.chart import Derived, LandmarkRule, derive_landmarks
from bodymeasure.chart.landmarks.rules import (
    Between,
    Boundary,
    Farthest,
    Fork,
    GirthLevel,
    Hollow,
    Level,
    Median,
    Prominent,
)

WAISTED = (2.0, 1.0, 1.2, 2.0)
# Points of the tube's first patch: on the generator through (radius, 0), at parameters v.
LOW, HIGH = AtlasPoint(0, 0.0, 0.1), AtlasPoint(0, 0.0, 0.9)


def given(atlas: Atlas, **landmarks: AtlasPoint) -> Atlas:
    return replace(atlas, landmarks=landmarks)


def place(atlas: Atlas, rule: LandmarkRule) -> Array:
    """The position of the landmark that a rule derives."""
    derived = derive_landmarks(atlas, [rule])
    assert derived.missing == {}
    return atlas.position(derived.landmarks[rule.name])


def reason(atlas: Atlas, rule: LandmarkRule) -> str:
    """The reason why a rule derives no landmark."""
    derived: Derived = derive_landmarks(atlas, [rule])
    assert rule.name not in derived.landmarks
    return derived.missing[rule.name]


def turned_about_z(atlas: Atlas, angle: float) -> Atlas:
    c, s = np.cos(angle), np.sin(angle)
    return replace(atlas, points=atlas.points @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T)


def quarter_farthest(angle: float) -> Array:
    """The point of the quarter curve (radius 1) that is farthest in the direction of an angle."""
    coordinate = QUARTER @ (np.cos(angle), np.sin(angle))
    first, middle, last = np.diff(coordinate)
    roots = np.roots([first - 2.0 * middle + last, 2.0 * (middle - first), first])
    (t,) = [float(root.real) for root in roots if 0.0 < root.real < 1.0]
    weights = np.array([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3])
    return np.asarray(weights @ QUARTER)


def radius(v: float, radii: tuple[float, ...] = WAISTED) -> float:
    return float(np.polynomial.Polynomial(_powers(radii))(v))


def root_inside(profile: np.polynomial.Polynomial, low: float, high: float) -> float:
    """The one root of a polynomial in an interval."""
    roots = [complex(root) for root in profile.roots()]
    (root,) = [r.real for r in roots if abs(r.imag) < 1e-12 and low < r.real < high]
    return root


def _powers(b: tuple[float, ...]) -> list[float]:
    """The power coefficients of a cubic in Bernstein form."""
    b0, b1, b2, b3 = b
    return [b0, 3 * (b1 - b0), 3 * (b2 - 2 * b1 + b0), b3 - 3 * b2 + 3 * b1 - b0]


@pytest.mark.parametrize("angle", [0.3, 1.0, 1.4])
def test_level_is_outermost_on_the_smooth_curve(angle: float) -> None:
    # Turned back by the angle, what lies there faces the wearer's left, +x.
    atlas = given(turned_about_z(tube(WAISTED), -angle), here=AtlasPoint(2, 0.3, 0.4))
    found = place(atlas, Level(name="there", of="here", facing="left"))
    x, y = radius(0.4) * quarter_farthest(angle)
    c, s = np.cos(angle), np.sin(angle)
    np.testing.assert_allclose(found, [c * x + s * y, c * y - s * x, 1.2], rtol=0.0, atol=1e-14)


def test_level_takes_the_loop_that_is_nearest_to_its_landmark() -> None:
    tubes = joined([tube([1.0] * 4, (x, 0.0)) for x in (-3.0, 0.0, 3.0)], ("a", "b", "c"))
    for number, x in enumerate((-3.0, 0.0, 3.0)):
        atlas = given(tubes, here=AtlasPoint(4 * number + 1, 0.6, 0.25))
        for facing, away in (("left", 1.0), ("right", -1.0)):
            found = place(atlas, Level(name="there", of="here", facing=facing))  # type: ignore[arg-type]
            np.testing.assert_allclose(found, [x + away, 0.0, 0.75], rtol=0.0, atol=1e-14)


def test_level_of_two_mirror_images_stays_on_its_landmarks_side() -> None:
    atlas = tube([1.0] * 4)
    # A dent in the front, with an equal bulge to its left and right.
    points = atlas.points.copy()
    points[(np.abs(points[:, 0]) < 1e-9) & (points[:, 1] < 0.0), 1] = -0.6
    atlas = replace(atlas, points=points)
    rule = Level(name="there", of="here", facing="front")
    found = {}
    for patch in range(4):
        here = AtlasPoint(patch, 0.5, 0.5)
        side = np.sign(atlas.position(here)[0])
        found[patch] = place(given(atlas, here=here), rule)
        assert np.sign(found[patch][0]) == side
    left, right = (next(f for f in found.values() if s * f[0] > 0.0) for s in (1.0, -1.0))
    np.testing.assert_allclose(left, right * [-1.0, 1.0, 1.0], rtol=0.0, atol=1e-14)
    assert left[1] < -0.7
    # In the middle, there is no side to stay on: it is the wearer's left.
    middle = given(atlas, here=AtlasPoint(1, 0.0, 0.5))
    np.testing.assert_array_equal(place(middle, rule), left)


def test_median_is_where_the_median_plane_meets_the_section() -> None:
    atlas = tube(WAISTED, center=(0.4, 0.0))
    atlas = given(atlas, here=AtlasPoint(3, 0.2, 0.9), axis=AtlasPoint(0, 0.0, 0.5))
    away = radius(0.5)
    across, along = (np.polynomial.Polynomial(_powers(tuple(QUARTER[:, i]))) for i in (0, 1))
    t = root_inside(across - away / radius(0.9), 0.0, 1.0)
    for facing, sign in (("back", 1.0), ("front", -1.0)):
        rule = Median(name="there", of="here", through="axis", facing=facing)  # type: ignore[arg-type]
        expected = [0.4 + away, sign * radius(0.9) * float(along(t)), 2.7]
        np.testing.assert_allclose(place(atlas, rule), expected, rtol=0.0, atol=1e-13)


def test_a_median_plane_beside_the_body_is_told() -> None:
    atlas = given(tube(WAISTED), wide=AtlasPoint(0, 0.0, 0.0), narrow=AtlasPoint(0, 0.0, 0.5))
    rule = Median(name="there", of="narrow", through="wide", facing="front")
    assert "at the height of 'narrow', no part of the body lies in the median" in reason(
        atlas, rule
    )


def test_a_median_point_is_not_taken_from_the_other_side() -> None:
    # The front of the tube is missing, so that the median plane meets its back only.
    whole = tube([1.0] * 4)
    half = replace(whole, index=whole.index[:2], patch_names=(), regions=())
    atlas = given(half, here=AtlasPoint(0, 0.4, 0.5), axis=AtlasPoint(1, 0.0, 0.5))
    back = place(atlas, Median(name="there", of="here", through="axis", facing="back"))
    np.testing.assert_allclose(back[:2], [0.0, 1.0], rtol=0.0, atol=1e-13)
    rule = Median(name="there", of="here", through="axis", facing="front")
    assert "at the height of 'here', the body is open at the front" in reason(atlas, rule)


def bump(a: float, b: float) -> Atlas:
    """Heights 1 - (x - a)^2 - (y - b)^2 over the unit square; up is y, and the front is z."""
    grid = np.arange(4) / 3
    square = np.array([0.0, 0.0, 1 / 3, 1.0])
    x, y = np.meshgrid(grid, grid, indexing="ij")
    xx, yy = np.meshgrid(square, square, indexing="ij")
    z = 1.0 - (xx - 2 * a * x + a * a) - (yy - 2 * b * y + b * b)
    net = np.stack([x, y, z], axis=-1)
    return replace(
        Atlas.from_control_points(net, "cm"),
        regions=("chest",),
        axes=Axes(up="+y", front="+z"),
        landmarks={"low": AtlasPoint(0, 0.1, 0.2), "high": AtlasPoint(0, 0.9, 0.75)},
    )


@pytest.mark.parametrize(
    ("a", "b", "above", "below", "expected"),
    [
        (0.3, 0.6, None, None, (0.3, 0.6)),
        (0.3, 0.6, "low", "high", (0.3, 0.6)),
        # The region is cut off by the limits of height and by edges of the patch.
        (0.3, 0.6, None, "low", (0.3, 0.2)),
        (0.3, 0.6, "high", None, (0.3, 0.75)),
        (0.3, 1.7, None, None, (0.3, 1.0)),
        (-0.2, 0.5, "low", None, (0.0, 0.5)),
        (-0.2, 1.5, None, None, (0.0, 1.0)),
        (1.4, 0.6, "high", None, (1.0, 0.75)),
    ],
)
def test_prominent_is_the_constrained_maximum(
    a: float, b: float, above: str | None, below: str | None, expected: tuple[float, float]
) -> None:
    rule = Prominent(name="top", direction="front", regions=("che",), above=above, below=below)
    found = place(bump(a, b), rule)
    np.testing.assert_allclose(found[:2], expected, rtol=0.0, atol=1e-12)


def test_prominent_tells_what_it_cannot_find() -> None:
    atlas = bump(0.3, 0.6)
    front = {"name": "top", "direction": "front"}
    assert "no region of the atlas begins with 'chess'; did you mean 'chest'?" in reason(
        atlas,
        Prominent(**front, regions=("chess",)),  # type: ignore[arg-type]
    )
    plain = replace(atlas, regions=("",))
    assert "no body regions" in reason(plain, Prominent(**front, regions=("chest",)))  # type: ignore[arg-type]
    between = Prominent(**front, regions=("chest",), above="high", below="low")  # type: ignore[arg-type]
    assert "'high' is not below 'low'" in reason(atlas, between)
    level = replace(
        joined([tube([1.0] * 4), tube([1.0] * 4, (5.0, 0.0))], ("a", "b")),
        landmarks={"top": AtlasPoint(0, 0.0, 1.0)},
    )
    rule = Prominent(name="side", direction="left", regions=("a",))
    assert "the surface is flat there across the direction" in reason(level, rule)
    beyond = replace(level, points=level.points + np.repeat([[0, 0, 0], [0, 0, 9]], 48, axis=0))
    far = Prominent(name="side", direction="left", regions=("b",), below="top")
    assert "no part of these regions lies between the two heights" in reason(beyond, far)


def test_hollow_is_deepest_below_the_chord() -> None:
    atlas = given(tube(WAISTED), low=LOW, high=HIGH)
    found = place(atlas, Hollow(name="waist", start="low", end="high"))
    profile = np.polynomial.Polynomial(_powers(WAISTED))
    slope = (radius(0.9) - radius(0.1)) / 0.8
    v = root_inside(profile.deriv() - slope, 0.1, 0.9)
    # The landmark is as exact as the path, which is a generator.
    np.testing.assert_allclose(found, [radius(v), 0.0, 3.0 * v], rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("flipped", [False, True])
def test_a_path_over_a_bulge_has_no_hollow(flipped: bool) -> None:
    atlas = tube([1.0, 1.2, 1.2, 1.0])
    if flipped:
        # The patches face inwards: the outside is found from the volume, not from u and v.
        atlas = replace(atlas, index=atlas.index[:, ::-1])
    ends = {
        name: min(
            (AtlasPoint(p, u, v) for p in range(4) for u in (0.0, 1.0)),
            key=lambda point: float(np.linalg.norm(atlas.position(point)[:2] - [9.0, 0.0])),
        )
        for name, v in (("low", 0.1), ("high", 0.9))
    }
    rule = Hollow(name="waist", start="low", end="high")
    atlas = given(atlas, **ends)
    assert "nowhere runs below its chord, so it has no hollow" in reason(atlas, rule)
    found = place(atlas, Hollow(name="waist", start="low", end="high", otherwise=0.5))
    # Half of the way up a profile that is symmetric.
    assert found[2] == pytest.approx(1.5, abs=1e-7)


def test_a_dent_that_is_too_shallow_is_no_hollow() -> None:
    atlas = given(tube(WAISTED), low=LOW, high=HIGH)
    deepest, halfway = (
        place(atlas, Hollow(name="w", start="low", end="high", least=least, otherwise=0.5))
        for least in (0.0, 0.5)
    )
    between = place(atlas, Between(name="m", start="low", end="high"))
    assert np.linalg.norm(deepest - halfway) > 1e-3
    np.testing.assert_array_equal(halfway, between)
    rule = Hollow(name="w", start="low", end="high", least=0.5)
    assert "it has no hollow" in reason(atlas, rule)
    rule = Hollow(name="w", start="low", end="high", otherwise=1.5)
    assert "otherwise is 1.5; expected 0 to 1" in reason(atlas, rule)


def test_the_farthest_of_several_landmarks() -> None:
    left, right = AtlasPoint(0, 0.0, 0.5), AtlasPoint(2, 0.0, 0.5)
    atlas = given(tube([1.0] * 4), low=LOW, high=HIGH, left=left, right=right)
    every = ("right", "left", "high", "low")
    for direction, name in (("up", "high"), ("down", "low"), ("right", "right")):
        found = place(atlas, Farthest(name="f", of=every, direction=direction))  # type: ignore[arg-type]
        np.testing.assert_array_equal(found, atlas.position(atlas.landmarks[name]))
    # If two are equally far, the left one is taken.
    found = place(atlas, Farthest(name="f", of=("right", "left"), direction="down"))
    np.testing.assert_array_equal(found, atlas.position(left))
    assert "of needs two landmarks or more" in reason(
        atlas, Farthest(name="f", of=("low",), direction="down")
    )


def test_between_is_a_part_of_the_way(rng: np.random.Generator) -> None:
    atlas = given(wavy_plane(rng), start=AtlasPoint(0, 0.2, 0.3), end=AtlasPoint(8, 0.6, 0.9))
    start, end = (atlas.position(atlas.landmarks[name]) for name in ("start", "end"))
    for fraction in (0.0, 0.25, 1.0):
        found = place(atlas, Between(name="m", start="start", end="end", fraction=fraction))
        expected = (1.0 - fraction) * start + fraction * end
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-7)
    rule = Between(name="m", start="start", end="end", fraction=1.5)
    assert "fraction is 1.5; expected 0 to 1" in reason(atlas, rule)


def test_between_parts_that_no_seam_joins_is_told() -> None:
    atlas = joined([tube([1.0] * 4), tube([1.0] * 4, (5.0, 0.0))], ("a", "b"))
    atlas = given(atlas, a=AtlasPoint(0, 0.5, 0.5), b=AtlasPoint(4, 0.5, 0.5))
    assert "no seams join" in reason(atlas, Between(name="m", start="a", end="b"))


@pytest.mark.parametrize(
    ("radii", "extreme"),
    [((2.0, 1.0, 1.2, 2.0), "smallest"), ((1.0, 1.7, 2.0, 1.0), "largest")],
)
def test_girth_level_is_found_to_nearly_all_digits(radii: tuple[float, ...], extreme: str) -> None:
    atlas = given(tube(radii), low=LOW, high=HIGH)
    rule = GirthLevel(name="w", start="low", end="high", extreme=extreme, facing="front")  # type: ignore[arg-type]
    found = place(atlas, rule)
    v = root_inside(np.polynomial.Polynomial(_powers(radii)).deriv(), 0.1, 0.9)
    np.testing.assert_allclose(found, [0.0, -radius(v, radii), 3.0 * v], rtol=0.0, atol=1e-9)


def test_a_girth_level_at_an_end_of_the_stretch_is_told() -> None:
    atlas = given(tube([1.0, 2.0, 3.0, 4.0]), low=LOW, high=HIGH)
    rule = GirthLevel(name="w", start="low", end="high", extreme="largest", facing="left")
    assert "the largest girth from 'low' to 'high' is at the end of the stretch" in reason(
        atlas, rule
    )


def test_boundary_is_the_extreme_of_the_open_edges() -> None:
    atlas = turned_about_z(tube(WAISTED), -1.0)
    # The tube slants, so that its upper edge is highest at one point.
    points = atlas.points @ np.array([[1.0, 0.0, 0.4], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    atlas = replace(atlas, points=points, regions=("sleeve left",) * 4)
    x, y = 2.0 * quarter_farthest(1.0)
    c, s = np.cos(1.0), np.sin(1.0)
    expected = np.array([c * x + s * y, c * y - s * x, 0.0])
    for direction, z in (("up", 3.0), ("down", 0.0)):
        sign = 1.0 if direction == "up" else -1.0
        found = place(
            atlas,
            Boundary(name="edge", direction=direction, regions=("sleeve",)),  # type: ignore[arg-type]
        )
        # The tube is its own mirror image in its axis.
        wanted = sign * expected + [0.0, 0.0, z]
        wanted[2] += 0.4 * wanted[0]
        np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-13)


def test_the_boundary_curve_nearest_to_a_landmark() -> None:
    # Two open tubes that slant, without any regions.
    atlas = joined([tube([1.0] * 4), tube([1.0] * 4, (5.0, 0.0))], ("", ""))
    slanting = atlas.points @ np.array([[1.0, 0.0, 0.4], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    low, high = AtlasPoint(4, 0.3, 0.1), AtlasPoint(4, 0.3, 0.9)
    atlas = given(replace(atlas, points=slanting), low=low, high=high)
    for near, z in (("low", 0.0), ("high", 3.0)):
        found = place(atlas, Boundary(name="e", direction="up", near=near))
        np.testing.assert_allclose(found, [6.0, 0.0, z + 0.4 * 6.0], rtol=0.0, atol=1e-12)
    rule = Boundary(name="e", direction="up", near="low", within=0.01)
    assert "the body seems not to be open there; pick the point" in reason(atlas, rule)
    assert "give either regions or near" in reason(atlas, Boundary(name="e", direction="up"))


def test_parts_that_are_one_or_join_nowhere_do_not_fork() -> None:
    atlas = joined([tube([1.0] * 4), tube([1.0] * 4, (5.0, 0.0))], ("", ""))
    here, above, there = AtlasPoint(0, 0.3, 0.1), AtlasPoint(1, 0.3, 0.4), AtlasPoint(4, 0.3, 0.2)
    atlas = given(atlas, here=here, above=above, there=there)
    rule = Fork(name="f", parts=("here", "above"))
    assert "the two places are on one horizontal loop of the body" in reason(atlas, rule)
    rule = Fork(name="f", parts=("here", "there"))
    assert "the horizontal loops of the two places join nowhere" in reason(atlas, rule)
    assert "give either regions or parts" in reason(atlas, Fork(name="f"))


def test_a_boundary_that_is_level_or_not_there_is_told() -> None:
    atlas = replace(tube(WAISTED), regions=("a",) * 4)
    rule = Boundary(name="edge", direction="up", regions=("a",))
    assert "the boundary is level where it is farthest up" in reason(atlas, rule)
    # The tube and itself inside out: every edge has two sides.
    index = np.concatenate([atlas.index, atlas.index[:, :, ::-1]])
    closed = Atlas(atlas.points, index, "cm", regions=("a",) * 8)  # type: ignore[arg-type]
    assert "no open boundary in these regions" in reason(closed, rule)
