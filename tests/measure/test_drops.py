"""Drops: lengths in vertical planes from a place to a level."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from helpers.bodies import ONE_QUICKLY, armpits
from helpers.speed import quick
from helpers.surfaces.tubes import tube
from scipy.spatial import ConvexHull

from bodymeasure._typing import Array
from bodymeasure.atlas import AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.measure import Drop, vertical_drop
from bodymeasure.samples import load_sample
from bodymeasure.section import Plane, outer_hull, part, plane_section, signed_area, turned

MEASURES = (
    ("back neck point", "back waist point", "median"),
    ("front neck point", "front waist point", "median"),
    ("side neck point {side}", "bust point {side}", "median"),
    ("side neck point {side}", "back waist point", "median"),
    ("side waist point {side}", "side hip point {side}", "side"),
    ("shoulder point {side}", "elbow point {side}", "side"),
)


def at(x: float, y: float, z: float) -> Array:
    return np.array([x, y, z])


def profile(radii: tuple[float, ...], low: float, high: float, count: int = 200_001) -> Array:
    """Many points (r, z) of a tube's side between two heights."""
    z = np.linspace(low, high, count)
    v = z / 3.0
    weights = np.stack([(1 - v) ** 3, 3 * v * (1 - v) ** 2, 3 * v**2 * (1 - v), v**3], axis=-1)
    return np.stack([weights @ np.array(radii), z], axis=-1)


@cache
def tube_lengths(radii: tuple[float, ...], low: float, high: float) -> tuple[float, float]:
    """Lengths along a tube's side between two heights, on its surface and taut."""
    points = profile(radii, low, high)
    # The hull of the profile and of two points far inside has three other sides, which are
    # subtracted.
    inside = np.array([[-50.0, points[0, 1]], [-50.0, points[-1, 1]]])
    hull = float(ConvexHull(np.concatenate([points, inside])).area)
    taut = hull - (points[[0, -1], 0] + 50.0).sum() - (points[-1, 1] - points[0, 1])
    return chain(points), float(taut)


def chain(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


@pytest.mark.parametrize("plane", ["median", "side"])
@pytest.mark.parametrize("facing", quick([1.0, -1.0]))
@pytest.mark.parametrize(("start", "level"), [(2.7, 0.4), (0.4, 2.7)])
@pytest.mark.parametrize(
    "radii",
    [(1.0, 2.0, 2.0, 1.0), (2.0, 1.0, 1.0, 2.0), (1.0, 2.5, 0.2, 1.5), (1.5, 0.2, 2.5, 1.0)],
)
def test_drops_along_tubes(
    radii: tuple[float, ...], start: float, level: float, facing: float, plane: str
) -> None:
    low, high = min(start, level), max(start, level)
    contact, taut = tube_lengths(radii, low, high)
    r = profile(radii, start, start, 1)[0, 0]
    out = at(0.0, facing, 0.0) if plane == "median" else at(facing, 0.0, 0.0)
    found = vertical_drop(tube(radii), r * out + at(0, 0, start), at(0, 0, level), plane=plane)  # type: ignore[arg-type]
    assert found.contact == pytest.approx(contact, rel=1e-9)
    assert found.taut == pytest.approx(taut, abs=1e-9)
    assert found.gap == found.contact - found.taut
    ends = found.arc.positions_at(np.array([0.0, float(found.arc.count)]))
    assert ends[:, 2] == pytest.approx([start, level], abs=1e-12)


def test_a_hollow_is_bridged_and_a_bulge_is_not() -> None:
    hollow, bulge = (
        vertical_drop(tube(radii), at(0.0, -2.0, 3.0), at(0.0, -2.0, 0.0))
        for radii in ([2.0, 1.0, 1.0, 2.0], [2.0, 3.0, 3.0, 2.0])
    )
    assert hollow.taut == pytest.approx(3.0, rel=1e-13)
    assert hollow.gap > 0.3
    assert bulge.taut == pytest.approx(bulge.contact, rel=1e-13)
    assert len(bulge.hull.bridges) == 0


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_drops_of_bodies(name: str) -> None:
    atlas = load_sample(name)
    for start, level, plane in MEASURES:
        both = []
        for side in ("left", "right") if "{side}" in start else ("",):
            found: Drop = vertical_drop(
                atlas,
                start.format(side=side),
                level.format(side=side),
                plane=plane,  # type: ignore[arg-type]
            )
            ends = found.arc.positions_at(np.array([0.0, float(found.arc.count)]))
            assert np.linalg.norm(ends[1] - ends[0]) <= found.taut <= found.contact
            assert found.error_estimate < 1e-9
            for tape, length in (
                (found.contact_tape, found.contact),
                (found.taut_tape, found.taut),
            ):
                # Chords of a smooth curve are shorter by the square of their number.
                assert 0.0 <= length - chain(tape.positions) < 1e-3 * length
                assert (tape.patch >= 0).all()
            both.append(found)
        assert both[0].contact == pytest.approx(both[-1].contact, rel=1e-6)
        assert both[0].taut == pytest.approx(both[-1].taut, rel=1e-6)


def test_the_rounding_of_a_body_does_not_change_its_tapes(rng: np.random.Generator) -> None:
    atlas = load_sample("male_average")
    shaken = replace(atlas, points=atlas.points + 1e-16 * rng.normal(size=atlas.points.shape))
    both = [
        vertical_drop(one, "side neck point left", "back waist point") for one in (atlas, shaken)
    ]
    assert abs(both[0].taut - both[1].taut) < both[0].error_estimate < 1e-12
    # The body is round from its side to the neck, where the tape lies on it.
    assert both[0].hull.spans[0, 0] > 2.0


@pytest.mark.parametrize("share", [0.4, 0.7, 0.9, 0.99])
def test_a_tape_lies_on_all_of_a_convex_arc(share: float) -> None:
    plane = Plane(at(0.0, 0.0, 1.5), at(0.0, 0.0, 1.0))
    (loop,) = plane_section(tube([1.0, 1.0, 1.0, 1.0]), plane).loops
    arc = part(loop, 0.3, 0.3 + share * loop.count)
    hull = outer_hull(arc, signed_area(loop.positions @ plane.frame().T))
    assert hull.length == pytest.approx(arc.length, rel=1e-13)
    assert len(hull.bridges) == 0


def test_the_level_tells_front_from_back() -> None:
    atlas = load_sample("female_average")
    front, back = (
        vertical_drop(atlas, "side neck point left", f"{side} waist point")
        for side in ("front", "back")
    )
    regions = [set(" ".join(found.arc.length_by_region).split()) for found in (front, back)]
    assert "back" not in regions[0]
    assert "front" not in regions[1] or back.arc.length_by_region["torso front left"] < 0.02
    assert "back" in regions[1]


def test_mistakes_are_named() -> None:
    atlas = load_sample("female_average")
    with pytest.raises(InputError, match=r"reaches the level, 0\.\d+ up from its start, nowhere"):
        vertical_drop(atlas, "back neck point", at(0.0, 0.0, 1.9))
    armpit, _ = armpits("female_average")
    with pytest.raises(InputError, match="only by going the other way first; choose a start"):
        vertical_drop(atlas, armpit, "side neck point left", plane="side")
    with pytest.raises(InputError, match=r"have one height.*expected two heights"):
        vertical_drop(atlas, "bust point left", "bust point left")
    with pytest.raises(InputError, match="plane is 'front'; expected 'median' or 'side'"):
        vertical_drop(atlas, "back neck point", "back waist point", plane="front")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="misses the body; move it"):
        vertical_drop(atlas, at(3.0, 0.0, 1.0), "back waist point")
    with pytest.raises(InputError, match="no landmark 'nape'"):
        vertical_drop(atlas, "nape", AtlasPoint(0, 0.0, 0.0))


def test_parts_and_turns() -> None:
    found = vertical_drop(tube([1.0, 2.0, 2.0, 1.0]), at(0.0, -1.0, 3.0), at(0.0, -1.0, 0.0))
    arc = found.arc
    halves = [part(arc, 0.0, 0.3), part(arc, 0.3, float(arc.count))]
    assert sum(half.length for half in halves) == pytest.approx(arc.length, rel=1e-13)
    back = turned(arc)
    assert back.positions_at(np.array([0.2])) == pytest.approx(
        arc.positions_at(np.array([arc.count - 0.2])), abs=1e-14
    )
    # From the other side of the surface the tape cuts straight through.
    assert outer_hull(arc, 1.0).length + outer_hull(arc, -1.0).length == pytest.approx(
        arc.length + 3.0, rel=1e-13
    )
