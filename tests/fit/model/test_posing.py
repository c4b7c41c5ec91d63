import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.fit.model import (
    body_model,
    bones_of,
    pose_derivatives,
    posed,
    shape_derivatives,
    shaped,
    skeleton,
    skinned,
    turned,
    unposed,
)

JOINTS = np.array([0, 3, 7, 9, 15, 17, 2, 16])


@pytest.fixture
def pose(rng: np.random.Generator) -> tuple[Array, Array, Array]:
    return rng.standard_normal(30), 0.3 * rng.standard_normal((31, 3)), rng.standard_normal(3)


def test_no_rotation_leaves_the_body_in_its_place(rng: np.random.Generator) -> None:
    coefficients = rng.standard_normal(20)
    shift = np.array([1.0, 2.0, 3.0])
    at_rest = posed(coefficients, np.zeros((31, 3)), shift)
    np.testing.assert_allclose(at_rest, shaped(coefficients) + shift, atol=1e-12)


def test_the_pelvis_turns_the_whole_body(pose: tuple[Array, Array, Array]) -> None:
    coefficients, rotations, shift = pose
    turn = Rotation.from_rotvec([0.3, -1.0, 2.0])
    whole = rotations.copy()
    whole[0] = (turn * Rotation.from_rotvec(rotations[0])).as_rotvec()
    pelvis = skeleton().joints_of(coefficients)[0] + shift
    expected = turn.apply(posed(coefficients, rotations, shift) - pelvis) + pelvis
    np.testing.assert_allclose(posed(coefficients, whole, shift), expected, atol=1e-12)


def test_a_forearm_turns_as_a_rigid_body_about_the_elbow() -> None:
    rotations = np.zeros((31, 3))
    elbow = skeleton().number("LeftForeArm")
    rotations[elbow] = [0.5, 0.2, -0.3]
    before, after = body_model().mean, posed(np.zeros(1), rotations)
    carried = skeleton().weights[:, skeleton().carries[elbow]].sum(axis=1).A1
    rigid, still = carried > 0.9999, carried < 1e-4
    place = skeleton().mean[elbow]
    turn = Rotation.from_rotvec(rotations[elbow])
    np.testing.assert_allclose(after[rigid], turn.apply(before[rigid] - place) + place, atol=1e-4)
    np.testing.assert_allclose(after[still], before[still], atol=1e-4)
    assert rigid.sum() > 1000
    assert still.sum() > 8000


def test_unposing_undoes_posing(pose: tuple[Array, Array, Array], rng: np.random.Generator) -> None:
    coefficients, rotations, shift = pose
    rotations = 0.5 * rotations
    beside = shaped(coefficients) + 0.01 * rng.standard_normal((13380, 3))
    vertices = skinned(beside, bones_of(coefficients, rotations, shift))
    np.testing.assert_allclose(unposed(vertices, coefficients, rotations, shift), beside, atol=1e-9)


def test_shape_derivatives_are_exact_as_skinning_is_linear(
    pose: tuple[Array, Array, Array],
) -> None:
    coefficients, rotations, shift = pose
    bones = bones_of(coefficients, rotations, shift)
    steps = shape_derivatives(body_model().components[:5], bones, skeleton().weights)
    moved = coefficients.copy()
    moved[:5] += [0.5, -1.0, 0.3, 0.2, -0.4]
    expected = posed(moved, rotations, shift) - posed(coefficients, rotations, shift)
    np.testing.assert_allclose(steps @ (moved - coefficients)[:5], expected, atol=1e-12)


def test_pose_derivatives_are_of_second_order(
    pose: tuple[Array, Array, Array], rng: np.random.Generator
) -> None:
    coefficients, rotations, shift = pose
    bones = bones_of(coefficients, rotations, shift)
    before = posed(coefficients, rotations, shift)
    steps = pose_derivatives(shaped(coefficients), bones, skeleton().weights, JOINTS)
    errors = []
    for size in (1e-2, 1e-3):
        for number in range(len(JOINTS)):
            # One joint at a time, since turns of a chain do not commute.
            turn = np.zeros((len(JOINTS), 3))
            turn[number] = size * rng.standard_normal(3)
            after = posed(coefficients, turned(rotations, bones, JOINTS, turn), shift)
            predicted = np.einsum("ndmk,mk->nd", steps, turn)
            gap = np.abs(after - before - predicted).max() / np.abs(predicted).max()
            errors.append(gap / np.linalg.norm(turn))
    # The relative error is a multiple of the step: half of it, for a lever at right angles.
    assert max(errors) < 3.0
    assert max(errors) > 0.1
