"""Landmarks derived by rules on the sample bodies and on quadrics."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.surfaces.quadrics import joined, sphere_nets, stretched

from bodymeasure import load_sample
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Axes
from bodymeasure.bezier import evaluate
from bodymeasure.chart import Derived, LandmarkRule, derive_landmarks, load_definitions
from bodymeasure.chart.landmarks.rules import Boundary, Fork, Level, Median, Prominent

# The change of a position, in meters, that rigid motions and mirroring may cause.
SAME = 1e-9
# Rules of all kinds without geodesics; those with them are slow, and only in the slow test.
RULES: Sequence[LandmarkRule] = (
    Level(name="side waist {side}", of="front waist point", facing="{side}"),
    Level(name="chest {side}", of="bust point {side}", facing="front"),
    Median(name="waist back", of="front waist point", through="back neck point", facing="back"),
    Prominent(name="bust {side}", direction="front", regions=("torso front {side}",)),
    Prominent(name="ribs {side}", direction="{side}", regions=("torso",), below="bust point left"),
    Boundary(name="wrist {side}", direction="{side}", regions=("forearm {side}",)),
    Boundary(name="ankle {side}", direction="down", regions=("lower leg {side}",)),
)


def positions(atlas: Atlas, derived: Derived) -> dict[str, Array]:
    return {
        name: atlas.position(derived.landmarks[name])
        for name in derived.rules
        if name in derived.landmarks
    }


def assert_symmetric(atlas: Atlas, derived: Derived) -> None:
    """Check that left landmarks are mirror images of right ones."""
    found = positions(atlas, derived)
    lefts = [name for name in found if name.endswith(" left")]
    assert lefts
    for name in lefts:
        right = found[name.replace("left", "right")]
        np.testing.assert_allclose(found[name], right * [-1.0, 1.0, 1.0], rtol=0.0, atol=SAME)


def turned(atlas: Atlas) -> tuple[Atlas, Array]:
    """The atlas moved, with its axes permuted: x to y, y to z, z to x; and the permutation."""
    permutation = np.roll(np.eye(3), 1, axis=0)
    shift = np.array([0.3, -1.1, 2.2])
    moved = replace(
        atlas, points=atlas.points @ permutation.T + shift, axes=Axes(up="+x", front="-z")
    )
    return moved, shift


def assert_moves_along(atlas: Atlas, rules: Sequence[LandmarkRule], derived: Derived) -> None:
    moved, shift = turned(atlas)
    there = positions(moved, derive_landmarks(moved, rules))
    here = positions(atlas, derived)
    assert there.keys() == here.keys()
    for name, position in here.items():
        back = np.roll(there[name] - shift, -1)
        np.testing.assert_allclose(back, position, rtol=0.0, atol=2.0 * SAME, err_msg=name)


def test_landmarks_are_symmetric_and_move_along_with_the_body() -> None:
    atlas = load_sample("female_average")
    derived = derive_landmarks(atlas, RULES)
    assert derived.missing == {}
    assert_symmetric(atlas, derived)
    assert_moves_along(atlas, RULES, derived)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_the_default_landmarks_move_along_with_the_body(name: str) -> None:
    atlas, rules = load_sample(name), load_definitions().landmark
    derived = derive_landmarks(atlas, rules)
    known = ("cannot be trusted", "it has no hollow")
    assert all(any(word in reason for word in known) for reason in derived.missing.values())
    assert len(derived.landmarks) > 60
    assert_moves_along(atlas, rules, derived)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["male_average"])
def test_the_default_landmarks_need_no_regions_but_one(name: str) -> None:
    atlas, rules = load_sample(name), load_definitions().landmark
    bare = replace(atlas, regions=())
    named, nameless = (derive_landmarks(body, rules, strict=False) for body in (atlas, bare))
    lost = {
        f"{kind} point {side}"
        for kind in ("back armhole", "back mid-armhole", "buttock")
        for side in ("left", "right")
    }
    assert set(nameless.missing) == lost
    here, there = positions(atlas, named), positions(bare, nameless)
    for found, position in there.items():
        np.testing.assert_allclose(position, here[found], rtol=0.0, atol=SAME, err_msg=found)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_average", "female_old"])
def test_parts_fork_where_regions_do(name: str) -> None:
    atlas = load_sample(name)
    regions = Fork(name="armpit {side}", regions=("torso", "upper arm {side}"))
    parts = Fork(name="armpit {side}", parts=("side waist point {side}", "elbow point {side}"))
    here, there = (positions(atlas, derive_landmarks(atlas, [rule])) for rule in (regions, parts))
    for side, position in here.items():
        np.testing.assert_allclose(there[side], position, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize(
    "name", [BODIES[0], *(pytest.param(name, marks=pytest.mark.slow) for name in BODIES[1:])]
)
def test_rules_give_what_dense_samples_give(name: str) -> None:
    atlas = load_sample(name)
    derived = derive_landmarks(atlas, RULES)
    found = positions(atlas, derived)
    side = np.linspace(0.0, 1.0, 60)
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)

    def samples(region: str) -> Array:
        patches = [i for i, r in enumerate(atlas.regions) if r.startswith(region)]
        nets = atlas.control_points[patches]
        return evaluate(nets, np.broadcast_to(grid, (len(nets), *grid.shape))).reshape(-1, 3)

    bust = samples("torso front left")
    # Never beyond what rules found, and nearly there.
    assert -1e-4 < found["bust left"][1] - bust[:, 1].min() <= 0.0
    low = atlas.position(atlas.landmarks["bust point left"])[2]
    torso = samples("torso")
    assert 0.0 <= found["ribs left"][0] - torso[torso[:, 2] <= low, 0].max() < 1e-3
    assert found["ribs left"][2] <= low + SAME
    ankle = samples("lower leg left")
    assert found["ankle left"][2] >= ankle[:, 2].min() - 1e-4
    waist = atlas.position(atlas.landmarks["front waist point"])[2]
    trunk = np.concatenate([samples("torso"), samples("hip")])
    near = np.abs(trunk[:, 2] - waist) < 3e-3
    assert found["side waist left"][0] == pytest.approx(trunk[near, 0].max(), abs=1e-3)
    assert found["side waist left"][2] == pytest.approx(waist, abs=SAME)
    assert found["waist back"][0] == pytest.approx(0.0, abs=1e-15)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_old"])
def test_picked_and_derived_landmarks_are_near_each_other(name: str) -> None:
    atlas = load_sample(name)
    rules: list[LandmarkRule] = [
        Prominent(name="bust {side}", direction="front", regions=("torso front {side}",)),
        Level(name="waist {side}", of="side waist point {side}", facing="{side}"),
        Median(name="hip", of="front hip point", through="back neck point", facing="front"),
        Fork(name="crotch", regions=("thigh left", "thigh right")),
        Fork(name="armpit {side}", regions=("torso", "upper arm {side}")),
    ]
    derived = derive_landmarks(atlas, rules)
    assert_symmetric(atlas, derived)
    found = positions(atlas, derived)
    picked = {key: atlas.position(point) for key, point in atlas.landmarks.items()}
    # In meters: picks are vertices of a mesh some centimeters wide.
    assert np.linalg.norm(found["bust left"] - picked["bust point left"]) < 0.035
    assert np.linalg.norm(found["waist left"] - picked["side waist point left"]) < 0.03
    np.testing.assert_allclose(found["hip"], picked["front hip point"], rtol=0.0, atol=1e-12)
    assert found["crotch"][0] == pytest.approx(0.0, abs=SAME)
    assert np.linalg.norm(found["crotch"] - picked["crotch point"]) < 0.05


def test_prominent_and_boundary_points_of_an_ellipsoid() -> None:
    """The extremes of rational patches are known."""
    whole = joined(stretched(sphere_nets(), (2.0, 1.5, 1.0)))
    turn = np.linalg.qr(np.array([[1.0, 0.4, 0.2], [-0.3, 1.0, 0.5], [0.1, -0.6, 1.0]]))[0]
    whole = replace(whole, points=whole.points @ turn.T, regions=("ball",) * len(whole))
    derived = derive_landmarks(
        whole,
        [
            Prominent(name="front", direction="front", regions=("ball",)),
            Prominent(name="top", direction="up", regions=("ball",)),
        ],
    )
    # The point of x^T A^-1 x = 1 farthest along d is A d / sqrt(d^T A d).
    shape = turn @ np.diag([4.0, 2.25, 1.0]) @ turn.T
    for name, direction in (("front", [0.0, -1.0, 0.0]), ("top", [0.0, 0.0, 1.0])):
        d = np.array(direction)
        expected = shape @ d / np.sqrt(d @ shape @ d)
        found = whole.position(derived.landmarks[name])
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-12)
    one = Atlas.from_control_points(whole.control_points[:1], "cm")
    one = replace(one, regions=("ball",))
    (edge,) = derive_landmarks(
        one, [Boundary(name="e", direction="back", regions=("ball",))]
    ).landmarks.values()
    sides = np.linspace(0.0, 1.0, 4001)
    rim = np.concatenate(
        [
            np.stack(np.broadcast_arrays(*pair), axis=-1)
            for pair in ((sides, 0.0), (sides, 1.0), (0.0, sides), (1.0, sides))
        ]
    )
    farthest = evaluate(one.control_points[0], rim)[:, 1].max()
    assert 0.0 <= one.position(edge)[1] - farthest < 1e-6
