"""Natural waists of the bodies."""

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.surfaces.tubes import ring_length, tube

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic import LoopKind, Status
from bodymeasure.measure import body_girth, closed_geodesic, extreme_girth, height
from bodymeasure.samples import load_sample


def at(x: float, y: float, z: float) -> Array:
    return np.array([x, y, z])


@pytest.mark.slow
def test_the_natural_waist() -> None:
    atlas = load_sample("female_average")
    waist = closed_geodesic(atlas, "front waist point")
    underbust = at(0.0, -0.2, height(atlas, "bust point left") - 0.07)
    for other in (
        closed_geodesic(atlas, underbust),
        closed_geodesic(atlas, "side waist point left"),
    ):
        assert other.length == pytest.approx(waist.length, rel=1e-10)
    assert (waist.status, waist.kind) == (Status.CONVERGED, LoopKind.MINIMUM)
    assert waist.error_estimate < 1e-9
    # The shortest level loop is no shorter than the shortest of all.
    level = extreme_girth(atlas, "front waist point", underbust, "smallest")
    assert waist.length <= level.girth.contact
    assert waist.length == pytest.approx(level.girth.contact, rel=0.02)
    positions = waist.position(np.linspace(0.0, 1.0, 50))
    mirrored = positions * (-1.0, 1.0, 1.0)
    many = waist.position(np.linspace(0.0, 1.0, 20_001))
    apart = np.linalg.norm(mirrored[:, None] - many, axis=2).min(axis=1)
    assert apart.max() < 1e-4


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES[2:4])
def test_hip_waist_and_underbust_slide_to_one_loop(name: str) -> None:
    atlas = load_sample(name)
    underbust = at(0.0, -0.2, height(atlas, "bust point left") - 0.07)
    lengths = [
        closed_geodesic(atlas, place).length
        for place in ("front hip point", "front waist point", underbust)
    ]
    assert lengths[1:] == pytest.approx([lengths[0]] * 2, rel=1e-8)


def test_mistakes_are_named() -> None:
    atlas = load_sample("female_average")
    with pytest.raises(InputError, match=r"merges the trunk and the left arm"):
        closed_geodesic(atlas, at(0.0, -0.2, height(atlas, "shoulder point left") - 0.06))
    top = float(atlas.points[:, 2].max())
    with pytest.raises(InputError, match=r"the section is open.*goes round nothing"):
        closed_geodesic(atlas, at(0.0, 0.0, top - 0.03))
    with pytest.raises(InputError, match="no landmark 'waist'"):
        closed_geodesic(atlas, "waist")


def test_what_was_not_judged_is_said() -> None:
    girth = body_girth(tube([1.0] * 4), at(1.0, 0.0, 1.0))
    assert girth.contact == pytest.approx(ring_length(), rel=1e-12)
    assert "was not checked, since the atlas names no regions" in girth.remark
    assert body_girth(load_sample("female_average"), "front waist point").remark == ""
