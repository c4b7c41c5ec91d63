"""The samples that come with bodymeasure, and the known lengths on which tests rely."""

import importlib
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.surfaces.surfaces import SURFACES, Surface
from scipy.integrate import solve_bvp

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Severity, Unit, check_atlas
from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.errors import InputError
from bodymeasure.samples import load_sample, sample_names, sample_path, samples

KNOWN = ("enneper", "hyperbolic_paraboloid", "paraboloid", "ph_cylinder", "tangent_developable")


@pytest.fixture(scope="module", params=BODIES)
def mannequin(request: pytest.FixtureRequest) -> Atlas:
    return load_sample(request.param)


def _mirrored(name: str) -> str:
    swap = {"left": "right", "right": "left"}
    return re.sub("left|right", lambda match: swap[match.group()], name)


def _centers(atlas: Atlas) -> Array:
    return evaluate(atlas.control_points, np.full((len(atlas), 2), 0.5))


def _numbers(atlas: Atlas, region: str) -> list[int]:
    return [i for i, name in enumerate(atlas.regions) if name == region]


def test_the_samples_are_the_mannequins_and_the_known_surfaces() -> None:
    assert sample_names() == tuple(sorted((*BODIES, *KNOWN)))
    listed = samples()
    assert [sample.name for sample in listed] == list(sample_names())
    assert all(sample.path.is_file() for sample in listed)
    described = {sample.name: sample.description for sample in listed}
    assert described["male_average"] == "Average male body, 174.8 cm; 376 patches, in m"
    assert described["enneper"] == "Enneper's surface; 1 patch, in cm"


@pytest.mark.parametrize("name", [*BODIES, *KNOWN])
def test_every_sample_is_sound_and_says_where_it_comes_from(name: str) -> None:
    atlas = load_sample(name)
    assert atlas.unit == (Unit.M if name in BODIES else Unit.CM)
    assert atlas.provenance["license"].startswith("CC0 1.0")
    assert atlas.provenance.get("source" if name in BODIES else "formula")
    assert [f for f in check_atlas(atlas) if f.severity is not Severity.WARNING] == []


def test_an_unknown_sample_is_answered_with_the_nearest_and_all() -> None:
    with pytest.raises(InputError, match=r"did you mean 'female_heavy'\? .*male_average, parab"):
        load_sample("female_hevy")
    with pytest.raises(InputError, match=r"named '\.\./README'; There are: enneper, "):
        sample_path("../README")


@pytest.mark.parametrize("name", KNOWN)
def test_known_surfaces_hold_the_control_points_and_length_of_their_formula(name: str) -> None:
    surface = next(surface for surface in SURFACES if surface.name == name)
    atlas = load_sample(name)
    np.testing.assert_allclose(atlas.control_points[0], surface.control_points, atol=1e-15)
    (digits,) = re.findall(r"([\d.]+) cm", atlas.provenance["known geodesic"])
    assert float(digits) == pytest.approx(surface.length, rel=1e-15)


def test_the_mirror_patch_has_the_mirrored_name(mannequin: Atlas) -> None:
    mirror = [mannequin.patch_number(_mirrored(name)) for name in mannequin.patch_names]
    assert sorted(mirror) == list(range(len(mannequin)))
    assert all(i != j for i, j in enumerate(mirror))
    centers = _centers(mannequin)
    np.testing.assert_allclose(centers[mirror], centers * [-1, 1, 1], atol=1e-12)
    assert tuple(_mirrored(mannequin.regions[i]) for i in mirror) == mannequin.regions


def test_names_begin_with_the_region_and_the_left_is_the_wearers(mannequin: Atlas) -> None:
    to_left = _centers(mannequin) @ mannequin.axes.left_vector
    for name, region, x in zip(mannequin.patch_names, mannequin.regions, to_left, strict=True):
        assert name.startswith(f"{region} ")
        assert region.endswith(" left" if x > 0 else " right")


def test_regions_lie_where_they_say(mannequin: Atlas) -> None:
    centers = _centers(mannequin)
    neck = mannequin.position(mannequin.landmarks["front neck point"])[2]
    crotch = mannequin.position(mannequin.landmarks["crotch point"])[2]
    knee = mannequin.position(mannequin.landmarks["patella point left"])[2]
    elbow = mannequin.position(mannequin.landmarks["elbow point left"])[0]
    z = {region: centers[_numbers(mannequin, region), 2] for region in set(mannequin.regions)}
    assert z["neck left"].min() > neck
    # The waist's ring of seams is not level: its landmarks differ in height by some centimeters.
    for aspect, point in (("front", ""), ("side", " left"), ("back", "")):
        waist = mannequin.position(mannequin.landmarks[f"{aspect} waist point{point}"])[2]
        torso, hip = z[f"torso {aspect} left"], z[f"hip {aspect} left"]
        assert torso.min() + 0.01 > waist > hip.max() - 0.01
        assert torso.min() > hip.max()
    assert knee < z["thigh left"].min()
    assert z["thigh left"].max() < crotch + 0.01
    assert z["lower leg left"].max() < z["knee left"].min() < knee
    x = {region: centers[_numbers(mannequin, region), 0] for region in set(mannequin.regions)}
    assert x["upper arm left"].max() < elbow + 0.03
    assert x["forearm left"].min() > x["upper arm left"].min()
    assert x["forearm left"].mean() > elbow
    # The front, side and back of each row follow one another from the front (-y) to the back.
    for part in ("torso", "hip"):
        front, side, back = (
            centers[_numbers(mannequin, f"{part} {aspect} left"), 1].mean()
            for aspect in ("front", "side", "back")
        )
        assert front < side < back


def test_rows_run_downwards_and_columns_outwards(mannequin: Atlas) -> None:
    centers = _centers(mannequin)
    for region in ("torso front left", "torso back left", "hip front left", "hip back left"):
        place = {}
        for i in _numbers(mannequin, region):
            match = re.search(r"(\d+)-(\d+)$", mannequin.patch_names[i])
            if match:
                place[int(match[1]), int(match[2])] = centers[i]
        # Around the side the columns turn inwards again; next to the center line they cannot.
        for (row, column), center in place.items():
            if column == 1:
                assert center[0] <= min(c[0] for (r, _), c in place.items() if r == row)
                below = place.get((row + 1, column))
                assert below is None or below[2] < center[2]
    for region in ("thigh left", "lower leg left"):
        heights = {
            name.removeprefix(f"{region} "): centers[i, 2]
            for i, name in enumerate(mannequin.patch_names)
            if name.startswith(region)
        }
        for key, height in heights.items():
            following = heights.get(f"{int(key[0]) + 1}{key[1:]}")
            assert following is None or following < height


def test_places_round_a_limb_are_where_they_say(mannequin: Atlas) -> None:
    centers = _centers(mannequin)
    for region in ("thigh left 2", "lower leg left 3", "knee left"):
        ring = {
            name.removeprefix(f"{region} "): centers[i]
            for i, name in enumerate(mannequin.patch_names)
            if name.startswith(region)
        }
        assert max(ring, key=lambda place: ring[place][0]) == "outer"
        assert min(ring, key=lambda place: ring[place][0]) == "inner"
        for side in ("inner", "outer"):
            assert ring[f"front {side}"][1] < ring[side][1] < ring[f"back {side}"][1]
        assert ring["front inner"][0] < ring["front outer"][0]


def test_all_mannequins_share_layout_and_names() -> None:
    first, *others = (load_sample(name) for name in BODIES)
    for other in others:
        np.testing.assert_array_equal(other.index, first.index)
        assert other.patch_names == first.patch_names
        assert other.regions == first.regions
        assert other.landmarks.keys() == first.landmarks.keys()
        assert other.digest != first.digest


def test_landmarks_lie_within_a_millimeter_of_the_body_and_are_symmetric(mannequin: Atlas) -> None:
    distances = dict(
        re.findall(r"([a-z ]+) ([\d.]+) mm", mannequin.provenance["landmark distances"])
    )
    assert {name.strip() for name in distances} == set(mannequin.landmarks)
    assert max(map(float, distances.values())) < 1.0
    assert len(mannequin.landmarks) == 21
    for name, point in mannequin.landmarks.items():
        twin = mannequin.position(mannequin.landmarks[_mirrored(name)])
        np.testing.assert_allclose(mannequin.position(point) * [-1, 1, 1], twin, atol=1e-12)


def test_samples_name_no_path_outside_the_project() -> None:
    for name in sample_names():
        text = sample_path(name).read_text(encoding="utf-8")
        assert "shared" not in text
        assert str(Path.home()) not in text


def test_the_limit_mask_is_where_subdivision_leads() -> None:
    control_mesh = importlib.import_module("bodymeasure.sample_patches.control_mesh")
    # All vertices of a box have valence 3; after one step they have 3 and 4.
    corners = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    corners[7] += 0.5
    quads = np.array(
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    )
    mesh = control_mesh.ControlMesh(corners, quads, {})
    finer = mesh
    for _ in range(3):
        finer = _catmull_clark(control_mesh, finer)
        limit = control_mesh.limit_positions(finer, range(8))
        np.testing.assert_allclose(
            limit, control_mesh.limit_positions(mesh, range(8)), rtol=0, atol=1e-14
        )
    # Vertices approach their limit by the subdominant eigenvalue at least, here below 0.5 a step.
    assert np.abs(finer.vertices[:8] - limit).max() < 0.5**3 * np.abs(corners - limit).max()


def _catmull_clark(control_mesh: Any, mesh: Any) -> Any:
    """Do one step of Catmull-Clark subdivision, with vertex points first."""
    vertices, quads = mesh.vertices, mesh.quads
    count = len(vertices)
    faces = vertices[quads].mean(axis=1)
    sides = np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1)
    edges, of_side = np.unique(np.sort(sides.reshape(-1, 2)), axis=0, return_inverse=True)
    of_side = of_side.reshape(-1, 4)
    face_sum = np.zeros((len(edges), 3))
    np.add.at(face_sum, of_side, np.repeat(faces[:, None], 4, axis=1))
    midpoints = vertices[edges].mean(axis=1)
    edge_points = (2.0 * midpoints + face_sum) / 4.0
    valence = np.bincount(quads.ravel())[:, None]
    face_mean, mid_mean = np.zeros((count, 3)), np.zeros((count, 3))
    np.add.at(face_mean, quads, np.repeat(faces[:, None], 4, axis=1))
    np.add.at(mid_mean, edges, np.repeat(midpoints[:, None], 2, axis=1))
    moved = (face_mean / valence + 2.0 * mid_mean / valence + (valence - 3) * vertices) / valence
    edge_number = count + of_side
    face_number = count + len(edges) + np.arange(len(quads))
    children = np.stack(
        [
            quads,
            edge_number,
            np.broadcast_to(face_number[:, None], quads.shape),
            np.roll(edge_number, 1, axis=1),
        ],
        axis=-1,
    ).reshape(-1, 4)
    return control_mesh.ControlMesh(np.concatenate([moved, edge_points, faces]), children, {})


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_a_boundary_value_solver_finds_the_known_length(surface: Surface) -> None:
    start, end = np.array(surface.start), np.array(surface.end)

    def flow(_: Array, state: Array) -> Array:
        """The geodesic equation for (u, v, u', v')."""
        s = derivatives(surface.control_points, state[:2].T, order=2)
        du, dv = state[2:, :, None]
        bend = s[:, 2, 0] * du**2 + 2.0 * s[:, 1, 1] * du * dv + s[:, 0, 2] * dv**2
        tangents = np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1)
        metric = tangents @ tangents.swapaxes(1, 2)
        second = -np.linalg.solve(metric, tangents @ bend[..., None])[..., 0]
        return np.concatenate([state[2:], second.T])

    def ends(at_start: Array, at_end: Array) -> Array:
        return np.concatenate([at_start[:2] - start, at_end[:2] - end])

    t = np.linspace(0.0, 1.0, 33)
    straight = start[:, None] + (end - start)[:, None] * t
    guess = np.concatenate([straight, np.repeat((end - start)[:, None], len(t), axis=1)])
    found = solve_bvp(flow, ends, t, guess, tol=1e-9, max_nodes=20_000)
    assert found.success

    path = found.sol(np.linspace(0.0, 1.0, 1001))[:2]
    assert (path > -1e-9).all(), "the geodesic must stay inside the patch"
    assert (path < 1 + 1e-9).all(), "the geodesic must stay inside the patch"
    nodes, weights = np.polynomial.legendre.leggauss(64)
    state = found.sol((nodes + 1.0) / 2.0)
    s = derivatives(surface.control_points, state[:2].T, order=1)
    velocity = s[:, 1, 0] * state[2][:, None] + s[:, 0, 1] * state[3][:, None]
    length = weights @ np.linalg.norm(velocity, axis=-1) / 2.0
    assert length == pytest.approx(surface.length, rel=1e-11)
