"""A scan with known truth: the body comes back, whatever the file's unit, axes and pieces."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.fit.model import atlas_of_vertices, body_model, limit_matrix, posed, unposed
from bodymeasure.fit.solving.state import normals_of

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parents[1] / "data" / "scans"
# A quarter turn that takes z to y.
Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


@pytest.fixture(scope="module")
def truth() -> Array:
    with np.load(FOLDER / "coarse_truth.npz") as data:
        return np.asarray(data["vertices"])


@pytest.fixture(scope="module")
def fitted() -> bm.FittedBody:
    return bm.fit_body(FOLDER / "coarse.ply", file_unit="m")


def _mesh() -> trimesh.Trimesh:
    mesh = trimesh.load(FOLDER / "coarse.ply", process=False)
    assert isinstance(mesh, trimesh.Trimesh)
    return mesh


def _in_frame(body: bm.FittedBody, truth: Array) -> Array:
    return np.asarray(truth @ body.transform[:3, :3].T + body.transform[:3, 3])


def _distances(vertices: Array, truth: Array) -> Array:
    """Distances of the limit positions that the atlas covers from the true limit surface."""
    inside = np.unique(body_model().quads[body_model().covered])
    points, surface = (limit_matrix() @ each for each in (vertices, truth))
    nearest = cKDTree(surface).query(points[inside])[1]
    steps = points[inside] - surface[nearest]
    return np.asarray(np.einsum("nd,nd->n", steps, normals_of(surface)[nearest]))


def test_the_surface_is_the_true_one(fitted: bm.FittedBody, truth: Array) -> None:
    gaps = _distances(fitted.vertices, _in_frame(fitted, truth))
    assert np.sqrt(np.mean(gaps**2)) < 0.9e-3
    assert np.percentile(np.abs(gaps), 95) < 1.7e-3


def test_landmarks_lie_near_the_true_ones(fitted: bm.FittedBody, truth: Array) -> None:
    # What a rule finds is compared with what it finds on the true body.
    true = bm.found_landmarks(atlas_of_vertices(_in_frame(fitted, truth))).atlas
    gaps = [np.linalg.norm(fitted.atlas.position(n) - true.position(n)) for n in true.landmarks]
    assert np.sqrt(np.mean(np.square(gaps))) < 6e-3
    assert set(fitted.atlas.landmarks) == set(true.landmarks)


def test_the_atlas_stands_on_the_floor_and_faces_the_front(fitted: bm.FittedBody) -> None:
    assert abs(fitted.scan.vertices[:, 2].min()) < 1e-12
    front, back = (fitted.atlas.position(f"{side} waist point") for side in ("front", "back"))
    assert front[1] < back[1] - 0.1
    left, right = (fitted.atlas.position(f"elbow point {side}") for side in ("left", "right"))
    assert left[0] > right[0] + 0.3
    assert not fitted.warnings
    assert fitted.scores.covered > 0.99
    np.testing.assert_allclose(fitted.coverage, 1.0, atol=0.7)


def test_shape_and_pose_are_those_of_the_body(fitted: bm.FittedBody) -> None:
    near = posed(fitted.coefficients, fitted.rotations, fitted.shift)
    inside = np.unique(body_model().quads[body_model().covered])
    gaps = np.linalg.norm(near - fitted.vertices, axis=1)[inside]
    assert np.sqrt(np.mean(gaps**2)) < 1.5e-3
    at_rest = unposed(fitted.vertices, fitted.coefficients, fitted.rotations, fitted.shift)
    assert np.ptp(at_rest[:, 2]) == pytest.approx(fitted.scores.stature, abs=5e-3)


def test_unit_and_axes_of_the_file_do_not_matter(fitted: bm.FittedBody, truth: Array) -> None:
    mesh = _mesh()
    vertices = 1e3 * np.asarray(mesh.vertices) @ Y_UP.T
    body = bm.fit_body((vertices, np.asarray(mesh.faces)), file_unit="mm", name="turned")
    assert "Found that +y is up." in body.atlas.scan.done  # type: ignore[union-attr]
    gaps = _distances(body.vertices, _in_frame(body, 1e3 * truth @ Y_UP.T))
    expected = _distances(fitted.vertices, _in_frame(fitted, truth))
    assert np.sqrt(np.mean(gaps**2)) == pytest.approx(np.sqrt(np.mean(expected**2)), abs=3e-4)


def test_a_picked_landmark_is_where_it_was_picked(truth: Array) -> None:
    true = atlas_of_vertices(truth)
    names = ("back neck point", "front waist point", "bust point left")
    # On the skin, 15 mm from where the landmark is carried to.
    picks = {name: true.position(name) for name in names}
    picks["bust point left"] = picks["bust point left"] + [0.0, 0.0, 0.015]
    body = bm.fit_body(FOLDER / "coarse.ply", file_unit="m", landmarks=picks)
    assert body.picked == names
    pulled = atlas_of_vertices(body.vertices)
    for name in names:
        at = _in_frame(body, picks[name])
        assert np.linalg.norm(body.atlas.position(name) - at) < 4e-3
        # The skin has followed, too.
        assert np.linalg.norm(pulled.position(name) - at) < 6e-3
        assert body.atlas.scan is not None
        assert body.atlas.scan.landmarks[name].origin is bm.LandmarkOrigin.PICKED
    gaps = _distances(body.vertices, _in_frame(body, truth))
    assert np.sqrt(np.mean(gaps**2)) < 1.1e-3


def test_a_pick_that_is_none_is_refused() -> None:
    with pytest.raises(bm.InputError, match="no landmark is named 'bust point lft'; did you mean"):
        bm.fit_body(FOLDER / "coarse.ply", file_unit="m", landmarks={"bust point lft": [0, 0, 0]})
    with pytest.raises(bm.FitError, match="mm from the scan; expected at most 30 mm"):
        bm.fit_body(FOLDER / "coarse.ply", file_unit="m", landmarks={"crotch point": [9, 0, 0]})


def test_progress_is_reported_to_the_end() -> None:
    seen: list[tuple[str, float]] = []
    body = bm.fit_body(
        FOLDER / "coarse.ply", file_unit="m", progress=lambda step, part: seen.append((step, part))
    )
    parts = [part for _, part in seen]
    assert parts == sorted(parts)
    assert seen[-1] == ("checking", 1.0)
    assert body.atlas.name == "coarse"


@pytest.mark.parametrize("shape", ["sphere", "chair", "two"])
def test_what_is_no_body_is_refused(shape: str) -> None:
    if shape == "sphere":
        mesh = trimesh.creation.icosphere(4, 0.8)
    elif shape == "chair":
        boxes = [((0.5, 0.5, 0.05), (0, 0, 0.45)), ((0.5, 0.05, 0.9), (0, 0.25, 0.9))]
        legs = [((0.05, 0.05, 0.45), (x, y, 0.2)) for x in (-0.2, 0.2) for y in (-0.2, 0.2)]
        parts = [
            trimesh.creation.box(size).apply_translation(place) for size, place in boxes + legs
        ]
        mesh = trimesh.util.concatenate([part.subdivide_to_size(0.03) for part in parts])
    else:
        one = _mesh()
        mesh = trimesh.util.concatenate([one, _mesh().apply_translation([1.0, 0.0, 0.0])])
    with pytest.raises(bm.InputError, match="expected"):
        bm.fit_body((np.asarray(mesh.vertices), np.asarray(mesh.faces)), file_unit="m")


def test_a_scan_without_feet_has_no_floor() -> None:
    mesh = _mesh()
    height = mesh.vertices[:, 2] - mesh.vertices[:, 2].min()
    kept = mesh.faces[(height[mesh.faces] > 0.08).all(axis=1)]
    body = bm.fit_body((mesh.vertices, kept), file_unit="m", up="+z")
    assert any("The scan does not reach the floor" in sentence for sentence in body.warnings)
    assert body.warnings == body.atlas.scan.warnings  # type: ignore[union-attr]
    assert "stature" not in body.atlas.given
    assert "head_height" in body.atlas.given
