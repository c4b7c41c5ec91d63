"""Binary glTF: the body's triangles with texture coordinates, and its skeleton as a skin.

Programs make vertex groups of the skin: Blender an armature and one group for each bone.
"""

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.export.body_mesh import BodyMesh, texture
from bodymeasure.fit.model import body_model, skeleton

# Numbers of glTF's specification, version 2.0: types of components, kinds of buffers, chunks.
_FLOAT, _BYTE, _INT = 5126, 5121, 5125
_VERTICES, _INDICES = 34962, 34963
_MAGIC, _JSON, _BIN = b"glTF", b"JSON", b"BIN\0"
_SHARES = 4


def glb_content(mesh: BodyMesh) -> bytes:
    """Return the content of a file."""
    places, corners = texture()
    quads = body_model().quads
    # A vertex with two places on the texture is two in glTF.
    pairs, number = np.unique(
        np.stack([quads.ravel(), corners.ravel()], axis=1), axis=0, return_inverse=True
    )
    split = number.reshape(quads.shape)
    triangles = np.concatenate([split[:, [0, 1, 2]], split[:, [0, 2, 3]]])
    vertices = pairs[:, 0]
    bones, shares = _skin()
    normals = _normals(mesh.vertices, quads)
    # Texture coordinates run downwards.
    flipped = places[pairs[:, 1]] * np.array([1.0, -1.0]) + np.array([0.0, 1.0])
    binding = np.tile(np.eye(4), (len(mesh.joints), 1, 1))
    binding[:, 3, :3] = -mesh.joints
    buffers = _Buffers()
    attributes = {
        "POSITION": buffers.add(mesh.vertices[vertices], _FLOAT, "VEC3", _VERTICES, bounds=True),
        "NORMAL": buffers.add(normals[vertices], _FLOAT, "VEC3", _VERTICES),
        "TEXCOORD_0": buffers.add(flipped, _FLOAT, "VEC2", _VERTICES),
        "JOINTS_0": buffers.add(bones[vertices], _BYTE, "VEC4", _VERTICES),
        "WEIGHTS_0": buffers.add(shares[vertices], _FLOAT, "VEC4", _VERTICES),
    }
    indices = buffers.add(triangles.reshape(-1, 1), _INT, "SCALAR", _INDICES)
    # The rows here are the columns of glTF's matrices.
    inverse = buffers.add(binding.reshape(-1, 16), _FLOAT, "MAT4", None)
    scene = {
        "asset": {"version": "2.0", "generator": "bodymeasure"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": mesh.name or "body", "mesh": 0, "skin": 0},
            *_bones(mesh.joints, first=1),
        ],
        "meshes": [
            {
                "name": mesh.name or "body",
                "primitives": [{"attributes": attributes, "indices": indices, "material": 0}],
                "extras": {"unit": "m", "described": mesh.described},
            }
        ],
        "materials": [{"name": "skin", "pbrMetallicRoughness": {"metallicFactor": 0.0}}],
        "skins": [
            {
                "inverseBindMatrices": inverse,
                "joints": list(range(1, 1 + len(mesh.joints))),
                "skeleton": 1,
            }
        ],
        "accessors": buffers.accessors,
        "bufferViews": buffers.views,
        "buffers": [{"byteLength": len(buffers.content)}],
    }
    return _packed(scene, bytes(buffers.content))


def _bones(joints: Array, first: int) -> list[dict[str, Any]]:
    """Return the nodes of the bones, each at its place relative to the one that carries it."""
    bones = skeleton()
    nodes = []
    for number, (name, parent) in enumerate(zip(bones.names, bones.parents.tolist(), strict=True)):
        from_parent = joints[number] - (joints[parent] if parent >= 0 else 0.0)
        node: dict[str, Any] = {"name": name, "translation": from_parent.tolist()}
        children = (np.flatnonzero(bones.parents == number) + first).tolist()
        nodes.append(node | ({"children": children} if children else {}))
    return nodes


def _skin() -> tuple[Ints, Array]:
    """Return the four bones of each vertex, shape (13380, 4), and their shares."""
    shares = skeleton().weights.toarray()
    bones = np.argsort(-shares, axis=1, kind="stable")[:, :_SHARES]
    found = np.take_along_axis(shares, bones, axis=1)
    # The specification asks for bone 0 where there is no share.
    bones = np.where(found > 0.0, bones, 0)
    return bones, found / found.sum(axis=1, keepdims=True)


def _normals(vertices: Array, quads: Ints) -> Array:
    first, second, third, fourth = np.moveaxis(vertices[quads], 1, 0)
    sums = np.zeros_like(vertices)
    np.add.at(sums, quads, np.cross(third - first, fourth - second)[:, None])
    return np.asarray(sums / np.maximum(np.linalg.norm(sums, axis=1, keepdims=True), 1e-30))


class _Buffers:
    """The binary part of a file, which grows array by array."""

    def __init__(self) -> None:
        self.content = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(
        self, values: NDArray[Any], kind: int, shape: str, target: int | None, bounds: bool = False
    ) -> int:
        """Append an array, and return the number of its accessor."""
        types = {_FLOAT: np.float32, _BYTE: np.uint8, _INT: np.uint32}
        data = np.ascontiguousarray(values, dtype=types[kind])
        view = {"buffer": 0, "byteOffset": len(self.content), "byteLength": data.nbytes}
        self.views.append(view | ({} if target is None else {"target": target}))
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": kind,
            "count": len(data),
            "type": shape,
        }
        if bounds:
            accessor |= {"min": data.min(axis=0).tolist(), "max": data.max(axis=0).tolist()}
        self.accessors.append(accessor)
        self.content += data.tobytes()
        # All arrays here have items of 4 bytes in all, so that each begins aligned.
        return len(self.accessors) - 1


def _packed(scene: dict[str, Any], binary: bytes) -> bytes:
    text = json.dumps(scene, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = b"".join(
        struct.pack("<I", len(content)) + kind + content
        for kind, content in ((_JSON, text), (_BIN, binary))
    )
    return _MAGIC + struct.pack("<II", 2, 12 + len(chunks)) + chunks
