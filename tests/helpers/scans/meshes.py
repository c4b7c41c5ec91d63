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


def ellipsoid(
    center: tuple[float, float, float], axes: tuple[float, float, float], rows: int = 16
) -> Mesh:
    """An ellipsoid of twice as many segments as rows, outwards."""
    around = 2 * rows
    u = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    v = np.linspace(0.0, np.pi, rows + 1)[1:-1]
    ring = np.stack(
        [
            np.outer(np.sin(v), np.cos(u)),
            np.outer(np.sin(v), np.sin(u)),
            np.outer(np.cos(v), np.ones(around)),
        ],
        axis=-1,
    )
    points = np.concatenate([ring.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    last = (rows - 2) * around
    top, bottom = last + around, last + around + 1
    faces = []
    for i in range(around):
        j = (i + 1) % around
        faces += [(top, i, j), (bottom, last + j, last + i)]
        for row in range(0, last, around):
            faces += [(row + i, row + around + i, row + around + j)]
            faces += [(row + i, row + around + j, row + j)]
    return points * axes + np.asarray(center), np.array(faces, dtype=np.int64)


def chair() -> Mesh:
    """A chair of boxes: a seat, a back and four legs."""
    legs = [box((x, y, 0.0), (x + 0.04, y + 0.04, 0.45)) for x in (0.0, 0.41) for y in (0.0, 0.41)]
    seat, back = box((0, 0, 0.45), (0.45, 0.45, 0.5)), box((0, 0.41, 0.5), (0.45, 0.45, 1.1))
    return joined(seat, back, *legs)


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
