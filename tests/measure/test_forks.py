"""Fork points of surfaces with known saddles, and of the bodies."""

import numpy as np
import pytest
from helpers.bodies import ONE_QUICKLY, armpits
from helpers.speed import quick
from helpers.surfaces.two_valleys import Knot, cubics, smooth, valleys
from scipy.spatial.transform import Rotation

from bodymeasure.atlas import Atlas, Axes
from bodymeasure.errors import InputError
from bodymeasure.measure import fork_point
from bodymeasure.samples import load_sample
from bodymeasure.section import Plane, plane_section

LEGS = ("leg left", "leg right")
VALLEY = (smooth(-2.0, 4.0, -4.0), smooth(2.0, 4.0, 4.0))
KINKED_VALLEY = (smooth(-2.0, 4.0, -3.0), Knot(0.0, 0.0, -1.0, 1.0), smooth(2.0, 4.0, 3.0))


def hill(*top: Knot) -> tuple[Knot, ...]:
    """A profile of two valleys with the given knots between."""
    return (smooth(-2.0, 2.0, -6.0), smooth(-1.0, -1.0), *top, smooth(1.0, -1.0), smooth(2, 2, 6))


@pytest.mark.parametrize("along", quick([KINKED_VALLEY, VALLEY]))
@pytest.mark.parametrize(
    "top", [smooth(0.0, 0.0), Knot(0.0, 0.0, 1.0, -1.0), Knot(0.0, 0.0, 0.5, -1.5)]
)
def test_saddles_on_seams_and_corners(top: Knot, along: tuple[Knot, ...]) -> None:
    atlas = valleys(hill(top), along)
    assert atlas.position(fork_point(atlas, LEGS)) == pytest.approx(np.zeros(3), abs=1e-12)


def test_a_saddle_inside_a_patch() -> None:
    knots = (smooth(-0.25, -0.05, 1.0), smooth(0.5, -0.2, -0.8))
    b = cubics(knots)[0]
    first, middle, last = np.diff(b)
    roots = np.roots([first - 2.0 * middle + last, 2.0 * (middle - first), first])
    (t,) = roots[(roots > 0.0) & (roots < 1.0)]
    known = np.polyval(
        [b[3] - 3 * b[2] + 3 * b[1] - b[0], 3 * (b[2] - 2 * b[1] + b[0]), 3 * (b[1] - b[0]), b[0]],
        t,
    )
    atlas = valleys(hill(*knots), VALLEY)
    point = fork_point(atlas, LEGS)
    assert atlas.position(point) == pytest.approx([-0.25 + 0.75 * t, 0.0, known], abs=1e-10)
    assert 0.0 < point.u < 1.0


def test_two_saddles_of_one_height_give_the_point_midway() -> None:
    top = (smooth(-0.3, 0.0), smooth(0.0, -0.1), smooth(0.3, 0.0))
    atlas = valleys(hill(*top), VALLEY)
    assert atlas.position(fork_point(atlas, LEGS)) == pytest.approx([0.0, 0.0, -0.1], abs=1e-9)


def test_forks_follow_the_axes() -> None:
    atlas = valleys(hill(smooth(0.0, 0.0)), VALLEY)
    lying = Atlas(
        atlas.points[:, [2, 0, 1]],
        atlas.index,
        atlas.unit,
        regions=atlas.regions,
        axes=Axes(up="+x", front="-z"),
    )
    assert lying.position(fork_point(lying, LEGS)) == pytest.approx(np.zeros(3), abs=1e-12)
    turn = Rotation.from_rotvec([0.0, 0.0, 0.3]).as_matrix()
    turned = Atlas(atlas.points @ turn.T, atlas.index, atlas.unit, regions=atlas.regions)
    assert turned.position(fork_point(turned, LEGS)) == pytest.approx(np.zeros(3), abs=1e-11)


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_armpits_and_crotch_of_bodies(name: str) -> None:
    atlas = load_sample(name)
    left, right = map(atlas.position, armpits(name))
    assert left == pytest.approx(right * (-1.0, 1.0, 1.0), abs=1e-6)
    assert 0.14 < left[0] < 0.20
    crotch = atlas.position(fork_point(atlas, ("thigh left", "thigh right")))
    assert abs(crotch[0]) < 1e-4
    assert np.linalg.norm(crotch - atlas.position(atlas.landmarks["crotch point"])) < 0.03
    if name == "female_average":
        # The loops divide there, and nowhere else in between.
        counts = [
            len(plane_section(atlas, Plane.horizontal(atlas, left[2] + move)).loops)
            for move in (-1e-6, 1e-6)
        ]
        assert counts == [3, 1]


def test_mistakes_are_named() -> None:
    atlas = load_sample("female_average")
    with pytest.raises(InputError, match=r"no region whose name begins with 'arm'; it has: crotch"):
        fork_point(atlas, ("torso", "arm"))
    for wrong in (("torso",), "torso"):
        with pytest.raises(InputError, match="expected the beginnings of two regions' names"):
            fork_point(atlas, wrong)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"share no height.*two neighboring parts"):
        fork_point(atlas, ("neck", "thigh"))
    with pytest.raises(InputError, match="no two horizontal loops that join farther up"):
        fork_point(atlas, ("torso front", "torso back"))
