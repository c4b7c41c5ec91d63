"""The quadrilateral control mesh of a Catmull-Clark surface, and points of that surface."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.subdivision import QuadMesh
from bodymeasure.subdivision import limit_positions as limits


@dataclass(frozen=True)
class ControlMesh:
    """A closed quad mesh: vertices (n, 3), quads (m, 4), and the quads of each named group."""

    vertices: Array
    quads: Ints
    groups: dict[str, Ints]


def read_mesh(path: Path) -> ControlMesh:
    """Read a Wavefront OBJ file of vertices, groups and quads, and nothing else."""
    vertices: list[list[float]] = []
    groups: dict[str, list[list[int]]] = {}
    group: list[list[int]] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            vertices.append([float(number) for number in rest])
        elif word == "g":
            group = groups.setdefault(rest[0], [])
        elif word == "f":
            group.append([int(number) - 1 for number in rest])
    quads = {name: np.array(rows) for name, rows in groups.items()}
    return ControlMesh(np.array(vertices), np.concatenate(list(quads.values())), quads)


def read_landmarks(path: Path) -> dict[str, int]:
    """Vertex numbers of the landmarks, by name."""
    landmarks: dict[str, int] = json.loads(path.read_text(encoding="utf-8"))["landmarks"]
    return landmarks


def limit_positions(mesh: ControlMesh, numbers: Sequence[int]) -> Array:
    """Return the limits of vertices of a mesh on its Catmull-Clark surface.

    Parameters
    ----------
    mesh : ControlMesh
    numbers : sequence of int, length k
        Vertices wanted.

    Returns
    -------
    ndarray, shape (k, 3)
    """
    return limits(QuadMesh(mesh.vertices, mesh.quads))[list(numbers)]
