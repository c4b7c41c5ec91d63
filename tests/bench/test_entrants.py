"""Every method of the benchmark, on lengths in closed form."""

import numpy as np
import pytest
from helpers.command_line import hide_here
from helpers.surfaces.surfaces import PLANE, SURFACES, plane_length

from bodymeasure.bench.entrants import mesh_paths
from bodymeasure.bench.entrants.boundary_value import BoundaryValueProblem
from bodymeasure.bench.entrants.entrant import Entrant
from bodymeasure.bench.entrants.entrants import entrants
from bodymeasure.bench.entrants.mesh_paths import igl_exact
from bodymeasure.bench.entrants.meshed_patch import MeshedPatch
from bodymeasure.bench.figure import LOOKS
from bodymeasure.bench.problems.patches import Problems, mild_patches
from bodymeasure.errors import InputError
from bodymeasure.geodesic import solve_geodesic

ENTRANTS = {entrant.label: entrant for entrant in entrants()}
MESH = [
    name
    for name in (
        "libigl exact",
        "pygeodesic exact",
        "potpourri3d edge flips",
        "unfolding [5]",
        "straightest, normals [6]",
    )
    if any(entrant.method == name for entrant in ENTRANTS.values())
]
STRAIGHTEST = "straightest [4], potpourri3d"
# The heat method is off by a few per cent.
HEAT_ERROR = 0.05
# Fast marching is off by a part of a per cent, whatever the mesh.
MARCHING_ERROR = 0.01
# Errors of a boundary value solver by its tolerance: the length's is about the square of the
# path's.
BVP_ERRORS = {"tol 1e-3": 1e-5, "tol 1e-6": 1e-8, "tol 1e-8": 1e-10}
# Relative errors of a path over a mesh by its points a side, which fall with the square of the
# step.
MESH_ERRORS = {"17 points a side": 3e-3, "33 points a side": 8e-4, "65 points a side": 2e-4}


def limit(entrant: Entrant[Problems]) -> float:
    if entrant.method == "libigl heat":
        return HEAT_ERROR
    if entrant.method.startswith("fast marching"):
        return MARCHING_ERROR
    if entrant.family == "mesh":
        return MESH_ERRORS[entrant.setting]
    return BVP_ERRORS[entrant.setting] if entrant.family == "scipy" else 1e-10


@pytest.mark.parametrize(
    "entrant",
    [
        pytest.param(each, id=name, marks=pytest.mark.slow if "65 points" in name else ())
        for name, each in ENTRANTS.items()
    ],
)
def test_lengths_in_closed_form(entrant: Entrant[Problems]) -> None:
    known = [s for s in SURFACES if (s.start, s.end) == ((0.0, 0.0), (1.0, 1.0))]
    problems = Problems(
        np.stack([s.control_points for s in known]),
        np.zeros((len(known), 2)),
        np.ones((len(known), 2)),
    )
    length = entrant.prepare(problems)()
    assert length.shape == (len(known),)
    truth = np.array([s.length for s in known])
    if entrant.method == STRAIGHTEST:
        # On saddles whose path runs through vertices no shot hits what lies behind the first.
        hit = np.isfinite(length)
        assert hit.sum() >= 3
        length, truth = length[hit], truth[hit]
    np.testing.assert_allclose(length, truth, rtol=limit(entrant), atol=0.0)


@pytest.mark.parametrize("method", MESH)
def test_meshes_converge_with_the_square_of_the_step(method: str) -> None:
    # On a paraboloid the path is a parabola; on Enneper's surface it is straight, and exact on any
    # mesh.
    surface = SURFACES[1]
    one = Problems(surface.control_points[None], np.zeros((1, 2)), np.ones((1, 2)))
    errors = [
        abs(ENTRANTS[f"{method}, {setting}"].prepare(one)()[0] / surface.length - 1.0)
        for setting in MESH_ERRORS
    ]
    rates = np.log2(np.divide(errors[:-1], errors[1:]))
    assert ((rates > 1.5) & (rates < 2.5)).all(), rates


@pytest.mark.parametrize("method", [*MESH, STRAIGHTEST])
def test_meshes_converge_where_nothing_is_symmetric(method: str) -> None:
    nets = mild_patches(np.random.default_rng(1), 6, 0.3)
    problems = Problems(nets, np.zeros((6, 2)), np.ones((6, 2)))
    truth = solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0)).length
    errors = []
    for setting in list(MESH_ERRORS)[:2]:
        length = ENTRANTS[f"{method}, {setting}"].prepare(problems)()
        errors.append(np.nanmedian(np.abs(length / truth - 1.0)))
    assert 1.5 < np.log2(errors[0] / errors[1]) < 2.7


def test_a_plane_is_exact_on_any_mesh() -> None:
    start, end = np.array([0.0, 0.25]), np.array([1.0, 0.5])
    mesh = MeshedPatch.of(PLANE, start, end, 5)
    assert igl_exact(mesh) == pytest.approx(plane_length((0.0, 0.25), (1.0, 0.5)), rel=1e-12)


@pytest.mark.parametrize("error", [RuntimeError, ValueError, ZeroDivisionError])
def test_a_library_that_raises_has_no_length(
    monkeypatch: pytest.MonkeyPatch, error: type[Exception]
) -> None:
    def fail(*_arguments: object) -> float:
        raise error("cannot")

    surface = SURFACES[0]
    one = Problems(surface.control_points[None], np.zeros((1, 2)), np.ones((1, 2)))
    call = ENTRANTS["libigl exact, 17 points a side"].prepare(one)
    monkeypatch.setattr(mesh_paths, "exact_distance", fail)
    assert np.isnan(call()).all()


def test_a_distance_that_is_none_is_a_failure() -> None:
    plane = MeshedPatch.of(PLANE, np.zeros(2), np.ones(2), 3)
    # Between two triangles that do not touch libigl returns 0.
    apart = MeshedPatch(
        np.concatenate([plane.vertices[:3], plane.vertices[:3] + 5.0]),
        np.array([[0, 1, 2], [3, 4, 5]]),
        0,
        3,
        PLANE,
        plane.parameters[:3],
        3,
    )
    with pytest.raises(InputError, match="libigl gives"):
        igl_exact(apart)


def test_a_solver_that_gives_up_has_no_length() -> None:
    # All control points are on a line, so that the metric is singular everywhere.
    line = np.zeros((4, 4, 3))
    line[..., 0] = np.add.outer(np.arange(4.0), np.arange(4.0))
    problem = BoundaryValueProblem(line, np.zeros(2), np.ones(2), tolerance=1e-6)
    assert np.isnan(problem())


def test_pygeodesic_takes_part_where_it_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    hide_here(monkeypatch, "pygeodesic")
    methods = {entrant.method for entrant in entrants()}
    assert methods == set(LOOKS) - {"pygeodesic exact"}


def test_each_method_can_be_drawn() -> None:
    assert {entrant.method for entrant in ENTRANTS.values()} | {"pygeodesic exact"} == set(LOOKS)
    assert len({(look.color, look.marker) for look in LOOKS.values()}) == len(LOOKS)
