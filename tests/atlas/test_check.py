"""The check of atlases: sound ones, and how findings are reported."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.flawed_atlases import (
    bumpy,
    flat,
    half_cylinder,
    separated,
)
from helpers.surfaces.grids import grid_atlas, grid_index
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Atlas,
    FindingKind,
    Severity,
    Unit,
    check_atlas,
)
from bodymeasure.samples import load_sample, sample_names


@given(
    seed=st.integers(0, 2**32 - 1),
    height=st.floats(0.0, 0.3),
    exponent=st.floats(-3.0, 6.0),
    turn=arrays(np.float64, (4,), elements=st.floats(-1.0, 1.0)),
    offset=arrays(np.float64, (3,), elements=st.floats(-10.0, 10.0)),
)
def test_mild_patches_are_sound_wherever_they_lie(
    seed: int, height: float, exponent: float, turn: Array, offset: Array
) -> None:
    assume(np.linalg.norm(turn) > 0.1)
    rng = np.random.default_rng(seed)
    flatland = np.stack(np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij"), axis=-1)
    field = np.concatenate([flatland, height * rng.random((4, 4, 1))], axis=-1)
    for net in (field, half_cylinder(), half_cylinder(radius=0.1)):
        placed = Rotation.from_quat(turn).apply(net.reshape(-1, 3)).reshape(4, 4, 3)
        atlas = Atlas.from_control_points((placed + offset) * 10.0**exponent, "mm")
        assert check_atlas(atlas) == ()


@given(seed=st.integers(0, 2**32 - 1), scale=st.sampled_from([1e-3, 1.0, 1e6]))
def test_a_smooth_surface_of_many_patches_is_sound(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=2)

    def place(x: Array, y: Array) -> Array:
        # The surface is quadratic in each variable: control points on a lattice of thirds join
        # smoothly.
        return scale * np.stack([x, y, 0.2 * (a * x + b * y)], axis=-1)

    assert check_atlas(grid_atlas(3, 4, place)) == ()


def test_a_narrow_strip_has_no_gap_between_its_long_sides() -> None:
    def narrow(x: Array, y: Array) -> Array:
        return flat(x, 0.02 * y)

    assert check_atlas(grid_atlas(3, 1, narrow)) == ()
    assert check_atlas(grid_atlas(3, 2, narrow)) == ()


def test_a_closed_tube_of_one_patch_is_sound() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 7)[:-1]
    lattice = np.stack(
        np.broadcast_arrays(np.cos(angle)[:, None], np.sin(angle)[:, None], np.arange(4.0)[None]),
        axis=-1,
    )
    numbers = np.arange(24).reshape(6, 4)
    index = np.stack([numbers[:4], numbers[[3, 4, 5, 0]]])
    findings = check_atlas(Atlas(lattice.reshape(-1, 3), index, Unit.CM))
    assert {finding.kind for finding in findings} <= {FindingKind.KINKED_SEAM}


@pytest.mark.parametrize("name", sample_names())
def test_samples_have_no_fault_but_kinks(name: str) -> None:
    findings = check_atlas(load_sample(name))
    assert {finding.kind for finding in findings} <= {FindingKind.KINKED_SEAM}


@pytest.mark.parametrize("scale", [1e300, 1e160, 1e-160, 1e-300])
def test_sizes_that_nothing_can_be_said_of_are_refused(scale: float) -> None:
    atlas = grid_atlas(1, 1)
    with pytest.raises(InputError, match=r"extends over .* choose another unit"):
        check_atlas(replace(atlas, points=scale * atlas.points))


def test_errors_come_first(rng: np.random.Generator) -> None:
    atlas = separated(bumpy(rng), 4, 0.01)
    index = atlas.index.copy()
    index[0] = index[0, ::-1]
    severities = [finding.severity for finding in check_atlas(replace(atlas, index=index))]
    assert len(set(severities)) == 2
    assert severities == sorted(severities, key=lambda severity: severity is Severity.WARNING)


def test_messages_use_the_patches_names_and_the_unit() -> None:
    atlas = separated(grid_atlas(2, 1), 1, 0.01)
    atlas = replace(atlas, patch_names=("hip left", "hip right")).converted(Unit.INCH)
    message = check_atlas(atlas)[0].message
    assert "'hip left'" in message
    assert "'hip right'" in message
    assert f"{0.01 / 2.54:.3g} inch" in message


def test_the_order_of_patches_does_not_matter(rng: np.random.Generator) -> None:
    atlas = separated(bumpy(rng), 4, 0.01)
    order = rng.permutation(len(atlas))
    names = tuple(atlas.patch_names[number] for number in order)
    shuffled = replace(atlas, index=atlas.index[order], patch_names=names, regions=())
    kinds = [sorted(f.kind for f in check_atlas(each)) for each in (atlas, shuffled)]
    assert kinds[0] == kinds[1]


def test_a_torus_of_patches_is_sound() -> None:
    rows = columns = 12
    index = grid_index(rows, columns)
    i, j = np.divmod(index, 3 * columns + 1)
    index = (i % (3 * rows)) * 3 * columns + j % (3 * columns)
    big = 2 * np.pi * np.arange(3 * rows)[:, None] / (3 * rows)
    small = 2 * np.pi * np.arange(3 * columns)[None] / (3 * columns)
    radius = 3.0 + np.cos(small)
    points = np.stack(
        np.broadcast_arrays(radius * np.cos(big), radius * np.sin(big), np.sin(small)), axis=-1
    )
    assert check_atlas(Atlas(points.reshape(-1, 3), index, Unit.CM)) == ()
