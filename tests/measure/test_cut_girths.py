"""Girths whose loop is cut at the armpits."""

import numpy as np
import pytest
from helpers.bodies import ONE_QUICKLY, armpits
from helpers.surfaces.tubes import tube
from scipy import optimize
from scipy.spatial import ConvexHull

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.measure import body_girth, breadth
from bodymeasure.samples import load_sample


def at(x: float, y: float, z: float) -> Array:
    return np.array([x, y, z])


def chain(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


@pytest.mark.parametrize(("left", "right"), [(0.5, -0.5), (0.9, 0.2), (0.999, -0.001)])
def test_a_cut_tube(left: float, right: float) -> None:
    atlas = tube([1.0] * 4)
    girth = body_girth(atlas, at(1, 0, 1), cut=(at(left, 0, 0), at(right, 5, 9)))
    whole = girth.loop
    place = np.linspace(0.0, float(whole.count), 20_001)
    points = whole.positions_at(place)[:, :2]
    inside = points[(points[:, 0] <= left) & (points[:, 0] >= right)]
    ends = [
        optimize.brentq(
            lambda t, x=x: whole.positions_at(np.array([t]))[0, 0] - x, *place[i : i + 2]
        )
        for x in (left, right)
        for i in np.flatnonzero(np.diff(np.sign(points[:, 0] - x)))
    ]
    hull = ConvexHull(np.concatenate([inside, whole.positions_at(np.array(ends))[:, :2]]))
    assert girth.contact == pytest.approx(float(hull.area), rel=1e-8)
    assert girth.taut == pytest.approx(girth.contact, rel=1e-12)
    assert breadth(atlas, girth.tape) == pytest.approx(left - right, rel=1e-12)
    assert chain(girth.contact_tape.positions) == pytest.approx(girth.contact, rel=2e-3)


def test_a_loop_between_the_planes_is_left_whole() -> None:
    atlas = tube([1.0] * 4)
    girth = body_girth(atlas, at(1, 0, 1), cut=(at(2, 0, 0), at(-2, 0, 0)))
    assert girth.tape is girth.loop
    assert girth.contact == body_girth(atlas, at(1, 0, 1)).contact


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_girths_above_the_armpits(name: str) -> None:
    atlas = load_sample(name)
    left, right = armpits(name)
    top = atlas.position(left)
    above = at(0.0, -0.2, top[2] + 0.01)
    with pytest.raises(InputError, match=r"merges the trunk.*cut at the armpits \(cut\)"):
        body_girth(atlas, above)
    girth = body_girth(atlas, above, cut=(left, right))
    assert 2.0 * breadth(atlas, girth.tape) <= girth.taut <= girth.contact < girth.loop.length
    assert breadth(atlas, girth.tape) == pytest.approx(2.0 * top[0], rel=1e-9)
    assert girth.error_estimate < 1e-11
    points = girth.tape.positions_at(np.linspace(0.0, float(girth.tape.count), 100_001))
    assert girth.taut == pytest.approx(float(ConvexHull(points[:, :2]).area), rel=1e-6)
    assert girth.contact == pytest.approx(chain(points), rel=1e-6)
    taut, contact = girth.taut_tape, girth.contact_tape
    assert chain(taut.positions) == pytest.approx(girth.taut, rel=1e-3)
    assert chain(contact.positions) == pytest.approx(girth.contact, rel=1e-3)
    # The tape is free over both cuts, where the arms have been cut off.
    assert (contact.patch < 0).sum() >= 2
    on_skin = taut.patch >= 0
    assert np.isnan(taut.parameters[~on_skin]).all()
    assert np.isfinite(taut.parameters[on_skin]).all()
    # Below the armpits nothing is merged, and nothing is cut.
    below = at(0.0, -0.2, top[2] - 0.03)
    assert body_girth(atlas, below, cut=(left, right)).taut == body_girth(atlas, below).taut


def test_mistakes_are_named() -> None:
    atlas = tube([1.0] * 4)
    with pytest.raises(InputError, match=r"from -0\.5 cm on the left to 0\.5 on the right.*first"):
        body_girth(atlas, at(1, 0, 1), cut=(at(-0.5, 0, 0), at(0.5, 0, 0)))
    with pytest.raises(InputError, match="leaves nothing between"):
        body_girth(atlas, at(1, 0, 1), cut=(at(0.5, 0, 0), at(0.5, 1, 0)))
    with pytest.raises(InputError, match=r"the left plane .*at 2 cm to the left, misses it"):
        body_girth(atlas, at(1, 0, 1), cut=(at(2, 0, 0), at(0, 0, 0)))
    with pytest.raises(InputError, match=r"the left plane .* misses it.*from 1 to -1"):
        body_girth(atlas, at(1, 0, 1), cut=(at(3, 0, 0), at(2, 0, 0)))
    for wrong in (("armpit left",), "armpit left"):
        with pytest.raises(InputError, match="expected two places: the left and the right armpit"):
            body_girth(atlas, at(1, 0, 1), cut=wrong)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="no landmark 'armpit left'"):
        body_girth(atlas, at(1, 0, 1), cut=("armpit left", "armpit right"))
