"""What is done to a mesh before a body is fitted to it, and what is said of it."""

import numpy as np
import pytest
from helpers.scans.meshes import box, ellipsoid, joined, volume

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.fit.scan import Scan, scan_of

TRUNK = ellipsoid((0.0, 0.0, 0.9), (0.3, 0.2, 0.85))
ARM = ellipsoid((0.5, 0.0, 0.9), (0.07, 0.08, 0.35))
PLATE = box((-0.4, -0.4, -0.02), (0.4, 0.4, 0.0))


def _scan(vertices: Array, triangles: Ints) -> Scan:
    return scan_of(vertices, triangles, file_unit="m")


def _closed(scan: Scan) -> float:
    return volume((scan.vertices, scan.triangles))


def test_vertices_are_welded_by_position() -> None:
    vertices, triangles = TRUNK
    soup = vertices[triangles].reshape(-1, 3)
    scan = _scan(soup, np.arange(len(soup)).reshape(-1, 3))
    assert scan.vertices.shape == vertices.shape
    assert scan.notes == (f"Welded {len(soup):,} vertices by position to {len(vertices)}.",)


def test_small_pieces_are_dropped() -> None:
    speck = ellipsoid((0.6, 0.0, 0.5), (0.05, 0.05, 0.05))
    scan = _scan(*joined(TRUNK, speck, speck[::1]))
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert any(note.startswith("Dropped 1 small piece, together") for note in scan.notes)


def test_each_piece_is_turned_right_side_out_by_itself() -> None:
    inside_out = ARM[0], ARM[1][:, ::-1]
    scan = _scan(*joined(TRUNK, inside_out))
    assert _closed(scan) == pytest.approx(volume(TRUNK) + volume(ARM))
    assert any(note.startswith("Turned 1 part of 2 right side out") for note in scan.notes)


def test_open_pieces_are_turned_by_their_bulge() -> None:
    vertices, triangles = TRUNK
    front = vertices[triangles].mean(axis=1)[:, 1] < 0.05
    turned = np.where(front[:, None], triangles, triangles[:, ::-1])
    # The halves share no vertices, so that neither sees how the other is turned.
    halves = joined(
        (vertices, turned[front]), (vertices + np.array([0.0, 0.02, 0.0]), turned[~front])
    )
    scan = _scan(*halves)
    outward = (scan.vertices[scan.triangles].mean(axis=1) - [0.0, 0.0, 0.9]) * [1.0, 1.0, 0.1]
    a, b, c = (scan.vertices[scan.triangles[:, corner]] for corner in range(3))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), outward) > 0.0).mean() > 0.99


def test_triangles_that_disagree_with_their_neighbors_are_turned() -> None:
    vertices, triangles = TRUNK
    mixed = triangles.copy()
    mixed[::7] = mixed[::7, ::-1]
    scan = _scan(vertices, mixed)
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert any("to agree with their neighbors" in note for note in scan.notes)


def test_a_mesh_inside_out_is_turned() -> None:
    scan = _scan(TRUNK[0], TRUNK[1][:, ::-1])
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert scan.notes == ("The mesh was inside out: turned all of its triangles round.",)


def test_the_inner_side_of_a_hollow_body_is_dropped() -> None:
    inner = TRUNK[0] * 0.98 + [0.0, 0.0, 0.018], TRUNK[1][:, ::-1]
    scan = _scan(*joined(TRUNK, inner))
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert "Dropped 1 piece inside the others, as of a hollow body." in scan.notes


def test_a_plate_beside_the_body_is_dropped() -> None:
    scan = _scan(*joined(TRUNK, PLATE))
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert not scan.plate.any()
    assert any(note.startswith("Dropped 1 flat piece, as a floor, ") for note in scan.notes)


def test_a_floor_that_is_joined_to_the_body_is_marked() -> None:
    vertices, triangles = joined(TRUNK, PLATE)
    # The lowest vertex of the ellipsoid becomes a corner of the plate.
    bridge = np.array([[481, len(TRUNK[0]) + 1, 0]])
    scan = _scan(vertices, np.concatenate([triangles, bridge]))
    assert scan.plate.any()
    height = scan.vertices[scan.triangles[scan.plate]][..., 2].max()
    assert height < 0.08
    area = _area(scan, scan.plate)
    assert area == pytest.approx(2.0 * 0.64 + 4.0 * 0.016, rel=0.05)
    assert any("for a floor or a stool" in note for note in scan.notes)


def _area(scan: Scan, which: Bools) -> float:
    a, b, c = (scan.vertices[scan.triangles[which][:, corner]] for corner in range(3))
    return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


def test_a_stool_under_the_body_is_marked_with_its_floor() -> None:
    stool = box((-0.2, -0.2, -0.4), (0.2, 0.2, 0.04))
    floor = box((-0.6, -0.6, -0.42), (0.6, 0.6, -0.4))
    vertices, triangles = joined(TRUNK, stool, floor)
    scan = _scan(vertices, triangles)
    assert scan.vertices[:, 2].min() > -0.01
    assert _closed(scan) == pytest.approx(volume(TRUNK))


def test_vertices_that_are_not_finite_take_their_triangles_along() -> None:
    vertices = TRUNK[0].copy()
    vertices[100] = np.nan
    scan = _scan(vertices, TRUNK[1])
    assert np.isfinite(scan.vertices).all()
    assert scan.notes == ("Dropped 6 triangles at 1 vertex whose coordinates are not finite.",)


def test_triangles_that_lead_far_away_are_dropped() -> None:
    vertices = TRUNK[0].copy()
    vertices[100] = (1e30, 0.0, -3e7)
    scan = _scan(vertices, TRUNK[1])
    assert np.abs(scan.vertices).max() < 2.0
    assert scan.notes == ("Dropped 6 triangles that lie or lead far away from all others.",)


def test_triangles_without_area_and_repeated_ones_are_dropped() -> None:
    vertices, triangles = TRUNK
    more = np.concatenate([triangles, [[3, 3, 4], [7, 8, 7]], triangles[:5, ::-1]])
    scan = _scan(vertices, more)
    assert _closed(scan) == pytest.approx(volume(TRUNK))
    assert scan.notes == (
        "Dropped 2 triangles without area.",
        "Dropped 5 triangles that repeat others.",
    )


def test_edges_with_three_triangles_are_tolerated() -> None:
    vertices, triangles = TRUNK
    fin = np.array([[*triangles[40][:2], len(vertices)]])
    scan = _scan(np.concatenate([vertices, [[0.0, 0.0, 3.0]]]), np.concatenate([triangles, fin]))
    assert len(scan.triangles) == len(triangles) + 1
    body = (scan.vertices[scan.triangles][..., 2] < 2.0).all(axis=1)
    assert volume((scan.vertices, scan.triangles[body])) == pytest.approx(volume(TRUNK))
