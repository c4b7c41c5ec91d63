"""Fitted bodies in files for other programs, read back by trimesh."""

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import trimesh
from helpers.bodies_in_poses import body_in_pose
from scipy.spatial import cKDTree

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.fit.export import write_fitted
from bodymeasure.fit.export.body_mesh import PARTS, quad_parts, to_gltf
from bodymeasure.fit.model import body_model, limit_matrix, posed, shaped, skeleton

SHIFT = np.array([0.1, -0.2, 0.05])


@pytest.fixture
def fitted() -> SimpleNamespace:
    vertices, coefficients, rotations = body_in_pose(4)
    return SimpleNamespace(
        vertices=vertices + SHIFT, coefficients=coefficients, rotations=rotations, shift=SHIFT
    )


@pytest.mark.parametrize("kind", [".obj", ".glb"])
@pytest.mark.parametrize("control", [False, True])
def test_a_mesh_has_the_vertices_of_the_body(
    tmp_path: Path, fitted: SimpleNamespace, kind: str, control: bool
) -> None:
    mesh = _read(tmp_path / f"body{kind}", fitted, control=control)
    wanted = to_gltf(fitted.vertices if control else limit_matrix() @ fitted.vertices)
    assert _apart(wanted, np.asarray(mesh.vertices)) < 1e-6
    assert len(mesh.faces) == 2 * len(body_model().quads)
    assert mesh.is_winding_consistent
    assert mesh.volume > 0.03


def test_the_a_pose_is_the_pose_undone(tmp_path: Path, fitted: SimpleNamespace) -> None:
    mesh = _read(tmp_path / "body.glb", fitted, a_pose=True, control=True)
    wanted = to_gltf(shaped(fitted.coefficients))
    wanted[:, 1] -= (limit_matrix() @ shaped(fitted.coefficients))[:, 2].min()
    assert _apart(wanted, np.asarray(mesh.vertices)) < 1e-6


def test_both_kinds_have_the_same_texture_coordinates(
    tmp_path: Path, fitted: SimpleNamespace
) -> None:
    first = _read(tmp_path / "body.obj", fitted)
    second = _read(tmp_path / "body.glb", fitted)
    pairs = [
        np.column_stack([mesh.vertices, mesh.visual.uv]).astype(float) for mesh in (first, second)
    ]
    assert _apart(*pairs) < 2e-6
    assert 0.0 <= pairs[0][:, 3:].min() < pairs[0][:, 3:].max() <= 1.0


def test_groups_of_an_obj_file_are_the_parts_of_the_body(
    tmp_path: Path, fitted: SimpleNamespace
) -> None:
    file = tmp_path / "body.obj"
    write_fitted(file, fitted)
    lines = file.read_text(encoding="utf-8").splitlines()
    assert [line[2:] for line in lines if line.startswith("g ")] == list(PARTS)
    faces = [line for line in lines if line.startswith("f ")]
    assert {len(line.split()) for line in faces} == {5}
    # Left is the wearer's left, +x, and so it is in the file.
    hand = body_model().quads[quad_parts() == list(PARTS).index("left_hand")]
    assert body_model().mean[hand, 0].min() > 0.3


def test_a_glb_file_has_the_skeleton_as_its_skin(tmp_path: Path, fitted: SimpleNamespace) -> None:
    scene, arrays = _glb(tmp_path / "body.glb", fitted)
    skin, primitive = scene["skins"][0], scene["meshes"][0]["primitives"][0]["attributes"]
    names = [scene["nodes"][number]["name"] for number in skin["joints"]]
    shares = arrays[primitive["WEIGHTS_0"]]
    bones = arrays[primitive["JOINTS_0"]]
    assert tuple(names) == skeleton().names
    assert np.abs(shares.sum(axis=1) - 1.0).max() < 1e-6
    assert bones.max() < len(names)
    # Each bone's matrix takes its own place to the origin.
    places = _places(scene, skin["joints"][0], np.zeros(3))
    matrices = arrays[skin["inverseBindMatrices"]].reshape(-1, 4, 4)
    for number, matrix in zip(skin["joints"], matrices, strict=True):
        assert np.abs([*places[number], 1.0] @ matrix - [0.0, 0.0, 0.0, 1.0]).max() < 1e-6
    # The wrist is within the left hand.
    wrist = places[skin["joints"][names.index("LeftHand")]]
    part = np.asarray(bones[:, 0] == names.index("LeftHand"))
    assert np.linalg.norm(arrays[primitive["POSITION"]][part] - wrist, axis=1).min() < 0.05


def test_coefficients_make_the_body_again(tmp_path: Path, fitted: SimpleNamespace) -> None:
    file = tmp_path / "body.json"
    write_fitted(file, fitted)
    found = json.loads(file.read_text(encoding="utf-8"))
    rotations = np.array([found["rotations"][name] for name in skeleton().names])
    again = posed(np.array(found["coefficients"]), rotations, np.array(found["shift"]))
    assert np.abs(again - fitted.vertices).max() < 1e-9


def test_what_cannot_be_written_is_refused(tmp_path: Path, fitted: SimpleNamespace) -> None:
    with pytest.raises(InputError, match=r"ends in one of \.obj, \.glb, \.json"):
        write_fitted(tmp_path / "body.fbx", fitted)
    with pytest.raises(InputError, match="expected a FittedBody, as fit_body returns it"):
        write_fitted(tmp_path / "body.obj", "no body")  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())


def _read(
    file: Path, fitted: SimpleNamespace, *, a_pose: bool = False, control: bool = False
) -> Any:
    write_fitted(file, fitted, a_pose=a_pose, control=control)
    return trimesh.load(file, process=False, force="mesh")


def _apart(wanted: Array, found: Array) -> float:
    """The largest distance of what is wanted from what is closest to it."""
    return float(cKDTree(found).query(wanted)[0].max())


def _glb(file: Path, fitted: SimpleNamespace) -> tuple[dict[str, Any], list[Array]]:
    write_fitted(file, fitted)
    content = file.read_bytes()
    length = int.from_bytes(content[12:16], "little")
    scene = json.loads(content[20 : 20 + length])
    binary = content[28 + length :]
    kinds: dict[int, type[np.generic]] = {5126: np.float32, 5121: np.uint8, 5125: np.uint32}
    widths = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
    arrays = []
    for accessor in scene["accessors"]:
        view, width = scene["bufferViews"][accessor["bufferView"]], widths[accessor["type"]]
        values = np.frombuffer(
            binary,
            kinds[accessor["componentType"]],
            accessor["count"] * width,
            view["byteOffset"],
        )
        arrays.append(values.reshape(-1, width).astype(float))
    return scene, arrays


def _places(scene: dict[str, Any], number: int, start: Array) -> dict[int, Array]:
    node = scene["nodes"][number]
    place = start + node["translation"]
    found = {number: place}
    for child in node.get("children", ()):
        found |= _places(scene, child, place)
    return found
