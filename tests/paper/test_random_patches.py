import numpy as np
import pytest

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.paper.data import random_patches
from bodymeasure.paper.data.random_patches import (
    HEIGHTS,
    INCREMENT,
    READINGS,
    Reading,
    draw,
    fault,
    make_testing_data,
)
from bodymeasure.paper.data.self_intersection import intersects_itself

readings = pytest.mark.parametrize("reading", READINGS, ids=lambda reading: reading.name)


@readings
def test_patches_keep_to_what_the_text_says(reading: Reading) -> None:
    data = make_testing_data(reading, 7, groups=2, size=15)
    nets = data.control_points
    assert nets.shape == (2, 15, 4, 4, 3)
    assert nets.min() >= 0.0
    assert nets.max() <= 1.0
    assert (nets[..., 0, 0, 2] == 0.0).all()
    assert (nets[..., 3, 3, 2] == 1.0).all()
    free = nets[..., 2].reshape(-1, 16)[:, 1:15] if reading.corners else nets[..., 1:3, :, 2]
    assert np.isin(free, HEIGHTS).all()
    assert set(np.unique(free)) == set(HEIGHTS)
    if reading.anywhere:
        steps = nets[..., :2] / INCREMENT
        np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)


@readings
def test_one_seed_gives_one_set_of_patches(reading: Reading) -> None:
    one, again, other = (make_testing_data(reading, seed, groups=2, size=5) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.control_points, again.control_points)
    assert (one.folded, one.intersecting) == (again.folded, again.intersecting)
    assert (one.control_points != other.control_points).any()
    assert (one.control_points[0] != one.control_points[1]).any()
    # A group does not depend on the number of groups.
    fewer = make_testing_data(reading, 1, groups=1, size=5)
    np.testing.assert_array_equal(one.control_points[0], fewer.control_points[0])


def test_the_corners_of_twelve_points_are_fixed() -> None:
    reading = next(reading for reading in READINGS if not reading.corners)
    heights = draw(reading, np.random.default_rng(0), 20)[..., 2]
    assert (heights[:, ::3, ::3] == [[0.0, 0.5], [0.5, 1.0]]).all()


def sheet(bend: float) -> Array:
    """A strip of width 1, rolled up in x and z by an angle; its end passes the start from pi on."""
    angle = np.linspace(0.0, bend, 4)
    profile = np.stack([np.array([0.0, 2.0, -1.0, 1.0]), 0 * angle, np.array([0, 1.0, 1.0, 0])], 1)
    net = profile[:, None] + np.linspace(0.0, 1.0, 4)[None, :, None] * np.array([0.0, 1.0, 0.0])
    return np.asarray(net)


def test_a_loop_cuts_through_itself() -> None:
    loop = sheet(1.0)
    assert intersects_itself(loop)
    assert fault(loop) == "intersecting"
    # This is the same profile without the crossing.
    wave = loop.copy()
    wave[1:3, :, 0] = [[0.3], [0.7]]
    assert not intersects_itself(wave)
    assert fault(wave) == ""


def test_a_loop_is_found_however_it_is_turned(rng: np.random.Generator) -> None:
    for _ in range(5):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        assert intersects_itself(sheet(1.0) @ turn + rng.normal(size=3))


def test_a_patch_that_doubles_back_is_folded() -> None:
    x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    flat = np.stack([x, y, 0.0 * x], axis=-1)
    assert fault(flat) == ""
    flat[1:3, :, 0] = [[1.5], [-0.5]]
    assert fault(flat) == "folded"


def test_a_collapsed_edge_is_refused() -> None:
    net = draw(READINGS[0], np.random.default_rng(0), 1)[0]
    net[0] = net[0, 0]
    assert fault(net) == "folded"


def test_rejected_patches_are_counted() -> None:
    reading = next(reading for reading in READINGS if reading.anywhere)
    data = make_testing_data(reading, 5, groups=1, size=20)
    rng = np.random.default_rng([5, READINGS.index(reading), 0])
    accepted, refused = 0, 0
    while accepted < 20:
        faults = [fault(net) for net in draw(reading, rng, 20 - accepted)]
        accepted += faults.count("")
        refused += len(faults) - faults.count("")
    assert data.folded + data.intersecting == refused
    assert refused > 0


def test_a_reading_without_sound_patches_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(random_patches, "fault", lambda _net: "folded")
    with pytest.raises(InputError, match=r"only 0 of .* patches drawn for the reading 'grid 1'"):
        make_testing_data(READINGS[0], 1, groups=1, size=2)
