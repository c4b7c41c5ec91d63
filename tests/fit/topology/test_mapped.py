"""Mapped bodies: where they stand, their pose, and what is refused."""

import numpy as np
import pytest
from helpers.bodies_in_poses import body_in_pose
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.errors import FitError
from bodymeasure.fit.model import body_model, limit_matrix, posed, shaped
from bodymeasure.fit.topology import MappedBody, mapped_body, polygons_of, posture_of, recognized
from bodymeasure.fit.topology.hm08 import smoothed_vertices


@pytest.mark.parametrize("unit", [Unit.M, Unit.CM, Unit.MM, Unit.INCH])
def test_any_unit_and_turn_of_a_file_give_the_same_body(unit: Unit) -> None:
    vertices = body_in_pose(1)[0]
    first = _mapped(vertices)
    # A file with y up whose body looks anywhere.
    turned = Rotation.from_euler("y", 2.0).apply(vertices[:, [0, 2, 1]] * [1.0, 1.0, -1.0])
    file = turned / unit.meters + 10.0
    found = _mapped(file, unit)
    assert np.abs(found.vertices - first.vertices).max() < 1e-6
    assert any("Up is +y" in note for note in found.notes)
    onto = file @ found.transform[:3, :3].T + found.transform[:3, 3]
    kept = np.setdiff1d(np.arange(len(onto)), smoothed_vertices())
    assert np.abs(onto - found.vertices)[kept].max() < 1e-6


def test_a_body_stands_on_the_floor_and_faces_the_front() -> None:
    found = _mapped(body_in_pose(2)[0])
    surface = limit_matrix() @ found.vertices
    assert abs(surface[:, 2].min()) < 1e-12
    again = _mapped(found.vertices)
    assert np.abs(again.transform - np.eye(4)).max() < 1e-9
    # The nose is before the neck, and the wearer's left hand on the left.
    mean = body_model().mean
    assert surface[mean[:, 1].argmin(), 1] < surface[:, 1].mean()
    assert surface[mean[:, 0].argmax(), 0] > 0.2 > -0.2 > surface[mean[:, 0].argmin(), 0]


def test_a_mirrored_body_is_refused() -> None:
    with pytest.raises(FitError, match="left and right are exchanged"):
        _mapped(body_in_pose(0)[0] * [-1.0, 1.0, 1.0])


def test_a_wrong_unit_is_refused() -> None:
    with pytest.raises(FitError, match=r"the body is 0\.00\d+ m long"):
        _mapped(body_in_pose(0)[0], Unit.MM)


def test_a_wrong_axis_is_refused() -> None:
    mesh = polygons_of(body_in_pose(0)[0], body_model().quads)
    topology = recognized(mesh)
    assert topology is not None
    with pytest.raises(FitError, match=r"points \d+ degrees away from \+y"):
        mapped_body(mesh, topology, Unit.M, up="+y")


@pytest.mark.parametrize("number", range(3))
def test_the_pose_of_a_body_is_found_and_undone(number: int) -> None:
    vertices, coefficients, _ = body_in_pose(number)
    found = posture_of(vertices)
    again = posed(found.coefficients, found.rotations, found.shift)
    assert found.residual < 2e-3
    assert _rms(again - vertices) < 3e-3
    # Joints and shape share what they explain, but the A-pose is close.
    assert _rms(found.a_pose(vertices) - shaped(coefficients)) < 8e-3
    assert _rms(vertices - shaped(coefficients)) > 20e-3


def _rms(difference: Array) -> float:
    return float(np.sqrt((difference**2).sum(axis=1).mean()))


def _mapped(vertices: Array, unit: Unit = Unit.M) -> MappedBody:
    mesh = polygons_of(vertices, body_model().quads)
    topology = recognized(mesh)
    assert topology is not None
    return mapped_body(mesh, topology, unit)
