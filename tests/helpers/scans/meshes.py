"""Triangle meshes for tests of scans, with known shapes."""

import numpy as np

from bodymeasure._typing import Array, Ints

Mesh = tuple[Array, Ints]


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> Mesh:
    """An axis-parallel box, outwards."""
    corners = np.array(
        [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    )
    quads = np.array(
        [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    )
    return corners, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def ellipsoid(center: tuple[float, float, float], axes: tuple[float, float, float]) -> Mesh:
    """An ellipsoid of 32 by 16 segments, outwards."""
    u = np.linspace(0.0, 2.0 * np.pi, 32, endpoint=False)
    v = np.linspace(0.0, np.pi, 17)[1:-1]
    ring = np.stack(
        [
            np.outer(np.sin(v), np.cos(u)),
            np.outer(np.sin(v), np.sin(u)),
            np.outer(np.cos(v), np.ones(32)),
        ],
        axis=-1,
    )
    points = np.concatenate([ring.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    faces = []
    for i in range(32):
        j = (i + 1) % 32
        faces += [(480, i, j), (481, 14 * 32 + j, 14 * 32 + i)]
        for row in range(14):
            a, b, c, d = row * 32 + i, row * 32 + j, row * 32 + 32 + i, row * 32 + 32 + j
            faces += [(a, c, d), (a, d, b)]
    return points * axes + np.asarray(center), np.array(faces, dtype=np.int64)


def joined(*meshes: Mesh) -> Mesh:
    """Several meshes as one."""
    before = np.cumsum([0, *(len(vertices) for vertices, _ in meshes)])
    return (
        np.concatenate([vertices for vertices, _ in meshes]),
        np.concatenate(
            [faces + first for (_, faces), first in zip(meshes, before[:-1], strict=True)]
        ),
    )


def volume(mesh: Mesh) -> float:
    """The volume that a closed mesh encloses, positive if it is outwards."""
    a, b, c = (mesh[0][mesh[1][:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)
