"""The plug-in of pyvista."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bodymeasure as bm

pyvista = pytest.importorskip("pyvista", minversion="0.48")
pytest.importorskip("igl")

from bodymeasure.plugin.remembered import mesh_of  # noqa: E402

NECK, BUST = "back neck point", "bust point left"


@pytest.fixture(scope="module")
def body():  # type: ignore[no-untyped-def]
    return bm.load_sample("female_average")


@pytest.fixture
def mesh(body):  # type: ignore[no-untyped-def]
    return mesh_of(body, segments=3)


def test_installing_is_all_that_a_user_does(tmp_path: Path, body) -> None:  # type: ignore[no-untyped-def]
    """A process that imports pyvista alone reads an atlas and measures it."""
    bm.write_atlas(body, tmp_path / "body.atlas")
    script = (
        "import sys, pyvista\n"
        "assert not any(name.startswith('bodymeasure.') for name in sys.modules)\n"
        "mesh = pyvista.read(sys.argv[1])\n"
        f"path = mesh.measure.path({NECK!r}, {BUST!r})\n"
        "print(repr(float(path.field_data['length'][0])), path.field_data['unit'][0])\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path / "body.atlas")],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    length, unit = done.stdout.split()
    expected = bm.geodesic_between(body, body.landmarks[NECK], body.landmarks[BUST]).length
    assert float(length) == pytest.approx(expected, rel=1e-12)
    assert unit == "m"


def test_a_mesh_keeps_its_atlas_through_copies_and_files(mesh, body, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    mesh.save(tmp_path / "body.vtp")
    for other in (mesh.copy(), pyvista.read(tmp_path / "body.vtp")):
        np.testing.assert_array_equal(other.measure.atlas.control_points, body.control_points)
        assert NECK in other.measure.landmarks


def test_places_are_vertices_positions_landmarks_and_points_of_the_atlas(mesh, body) -> None:  # type: ignore[no-untyped-def]
    point = body.landmarks[NECK]
    end = mesh.points[200]
    lengths = [mesh.measure.distance(start, 200) for start in (NECK, point, body.position(point))]
    np.testing.assert_allclose(lengths, mesh.measure.distance(NECK, end), rtol=1e-9)


def test_girths_are_closed_lines(mesh, body) -> None:  # type: ignore[no-untyped-def]
    line = mesh.measure.girth("front waist point")
    girth = bm.body_girth(body, "front waist point")
    assert line.field_data["length"][0] == girth.contact
    assert line.field_data["taut"][0] == girth.taut
    np.testing.assert_array_equal(line.points[0], line.points[-1])


@pytest.mark.parametrize("move", ["translate", "scale", "rotate_z"])
def test_a_mesh_that_was_moved_is_not_measured_by_its_old_atlas(mesh, move: str) -> None:  # type: ignore[no-untyped-def]
    amount = {"translate": (0.1, 0.0, 0.0), "scale": 100.0, "rotate_z": 30.0}[move]
    moved = getattr(mesh, move)(amount, inplace=False)
    with pytest.raises(bm.InputError, match=r"away from the atlas that it remembers: it was moved"):
        moved.measure.path(NECK, BUST)


def _one_vertex_moved(mesh) -> None:  # type: ignore[no-untyped-def]
    mesh.points[777] += (0.0, 0.3, 0.0)


def _not_a_number(mesh) -> None:  # type: ignore[no-untyped-def]
    mesh.points[5] = np.nan


def _other_patches(mesh) -> None:  # type: ignore[no-untyped-def]
    mesh.point_data["bodymeasure_patch"] = np.full(mesh.n_points, 376)


def _no_parameters(mesh) -> None:  # type: ignore[no-untyped-def]
    mesh.point_data["bodymeasure_uv"] = np.zeros(mesh.n_points)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (_one_vertex_moved, r"the mesh is 0\.3 away from the atlas that it remembers"),
        (_not_a_number, r"the mesh is nan away from the atlas"),
        (_other_patches, r"'bodymeasure_uv' were changed: .* on the atlas's 376 patches"),
        (_no_parameters, r"'bodymeasure_uv' were changed"),
    ],
)
def test_a_mesh_that_was_changed_is_refused(mesh, change: Any, message: str) -> None:  # type: ignore[no-untyped-def]
    change(mesh)
    with pytest.raises(bm.InputError, match=message):
        mesh.measure.path(NECK, BUST)


def test_new_vertices_along_a_cut_are_no_places_of_the_atlas(mesh) -> None:  # type: ignore[no-untyped-def]
    """The patches and parameters of new vertices would be means of those of others."""
    # The plane is so high that few of all vertices are new.
    cut = mesh.clip((0.3, 0.1, 1.0), origin=(0.0, 0.0, 1.3), invert=True)
    with pytest.raises(bm.InputError, match=r"moved, scaled, deformed or cut since it was read"):
        cut.measure.path(NECK, BUST)
    # Leaving out faces makes no new vertices.
    less = mesh.remove_cells(range(100))
    assert less.measure.distance(NECK, BUST) == pytest.approx(mesh.measure.distance(NECK, BUST))


def test_a_mesh_that_is_no_surface_is_refused() -> None:
    with pytest.raises(bm.InputError, match=r"a ImageData, which is no surface.*extract_surface"):
        bm.measure_mesh(pyvista.ImageData(dimensions=(3, 3, 3)), 0, 5)


def test_a_plain_mesh_says_that_it_is_one() -> None:
    sphere = pyvista.Sphere()
    assert sphere.measure.atlas is None
    path = sphere.measure.path(0, 1, unit="cm")
    length = float(path.field_data["length"][0])
    assert abs(length - np.pi / 2.0) <= path.field_data["error_estimate"][0]
    assert str(path.field_data["status"][0]) == "MESH"
    assert "on the mesh itself" in str(path.field_data["sentence"][0])
    assert str(path.field_data["unit"][0]) == "cm"
    with pytest.raises(bm.InputError, match=r"'neck', but this mesh remembers no atlas"):
        sphere.measure.path("neck", 1)
    with pytest.raises(bm.InputError, match=r"girths are for meshes read from an atlas"):
        sphere.measure.girth(0)


def test_quads_are_measured_as_triangles() -> None:
    plane = pyvista.Plane(i_resolution=3, j_resolution=3)
    assert plane.measure.distance(0, 15) == pytest.approx(np.sqrt(2.0), rel=1e-6)


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ("bust point lef", r"no landmark 'bust point lef'; did you mean 'bust point left'"),
        (10**6, r"vertex 1000000 is not there"),
        ((0.0, 0.0), r"the place is .*expected three finite numbers, a landmark's name or"),
        ((100.0, 0.0, 0.0), r"from the surface.*check its coordinates, its unit"),
        (object(), r"the place is .*expected three finite numbers, a landmark's name or"),
        (("a", "b", "c"), r"the place is .*expected three finite numbers, a landmark's name or"),
    ],
)
def test_bad_places_are_refused(mesh, place, message: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(bm.InputError, match=message):
        mesh.measure.path(NECK, place)


def test_files_without_a_unit_are_read_and_say_so(tmp_path: Path) -> None:
    bm.write_atlas(bm.load_sample("paraboloid"), tmp_path / "p.bpt")
    for options, unit in (({}, ""), ({"unit": "cm"}, "cm")):
        mesh = pyvista.read(tmp_path / "p.bpt", **options)
        assert str(mesh.measure.path(0, 5).field_data["unit"][0]) == unit
    with pytest.raises(bm.InputError, match=r"unknown option 'units'; expected unit or segments"):
        pyvista.read(tmp_path / "p.bpt", units="cm")


def test_paths_are_drawn(mesh) -> None:  # type: ignore[no-untyped-def]
    path = mesh.measure.path(NECK, BUST)
    with pyvista.vtk_verbosity("off"):
        plotter = pyvista.Plotter(off_screen=True, window_size=(300, 400))
        try:
            mesh.measure.draw(plotter)
            plain = plotter.screenshot(None, return_img=True)
            mesh.measure.draw(plotter, path)
            drawn = plotter.screenshot(None, return_img=True)
        finally:
            plotter.close()
    changed = np.abs(drawn.astype(int) - plain.astype(int)).max(axis=-1) > 40
    assert 20 < changed.sum() < 0.2 * changed.size


@pytest.fixture
def clicking(mesh) -> Any:  # type: ignore[no-untyped-def]
    """A plotter in which pairs of points of the mesh are picked, and what its corner says."""
    from bodymeasure.scene.drawing.opengl_check import opengl_trouble

    if opengl_trouble():
        pytest.skip(opengl_trouble())
    with pyvista.vtk_verbosity("off"):
        plotter = pyvista.Plotter(off_screen=True, window_size=(400, 500))
        paths = mesh.measure.pick(plotter)
        plotter.view_vector((0.0, -1.0, 0.0), viewup=(0.0, 0.0, 1.0))
        plotter.enable_parallel_projection()
        plotter.screenshot(None, return_img=True)
        yield plotter, paths
        plotter.close()


def _press(plotter: Any, position: Any, move: int = 0, *, shift: bool = False) -> None:
    """Press the left button where a position is seen, move, and release it."""
    plotter.renderer.SetWorldPoint(*position, 1.0)
    plotter.renderer.WorldToDisplay()
    x, y = (round(value) for value in plotter.renderer.GetDisplayPoint()[:2])
    events = plotter.iren.interactor
    events.SetEventInformation(x, y, 0, shift)
    events.LeftButtonPressEvent()
    events.SetEventInformation(x + move, y, 0, shift)
    events.MouseMoveEvent()
    events.LeftButtonReleaseEvent()


def _corner(plotter: Any) -> str:
    return str(plotter.actors["measure"].get_text(2))


def test_two_clicked_points_are_measured(clicking: Any, body: bm.Atlas) -> None:
    plotter, paths = clicking
    assert _corner(plotter) == "click where the path is to start"
    _press(plotter, body.position(body.landmarks[BUST]), move=50)
    assert _corner(plotter) == "click where the path is to start"
    plotter.view_vector((0.0, -1.0, 0.0), viewup=(0.0, 0.0, 1.0))
    _press(plotter, body.position(body.landmarks[BUST]), move=2)
    assert _corner(plotter).startswith("click where the path is to end, or with shift")
    _press(plotter, body.position(body.landmarks["front hip point"]))
    (path,) = paths
    expected = bm.geodesic_between(body, path.points[0], path.points[-1])
    assert path.field_data["length"][0] == pytest.approx(expected.length, rel=1e-9)
    # A pixel of this window is some 4 mm, the mesh is within a few millimeters of the body.
    near = bm.geodesic_between(body, BUST, "front hip point").length
    assert path.field_data["length"][0] == pytest.approx(near, abs=0.015)
    first, second = _corner(plotter).split("\n", 1)
    assert first.startswith(f"{path.field_data['length'][0]:.6g} m, error ")
    straight = float(path.field_data["straight"][0])
    assert straight == pytest.approx(np.linalg.norm(path.points[-1] - path.points[0]), rel=1e-3)
    assert first.endswith(f", straight {straight:.4g} m")
    assert second == str(path.field_data["sentence"][0])


def test_a_click_with_shift_is_a_point_on_the_way(clicking: Any, body: bm.Atlas) -> None:
    plotter, paths = clicking
    places = [BUST, "front waist point", "front hip point"]
    for name in places:
        _press(plotter, body.position(body.landmarks[name]), shift=name == places[1])
    (path,) = paths
    expected = bm.geodesic_between(body, places[0], places[2], places[1:2]).length
    assert path.field_data["length"][0] == pytest.approx(expected, abs=0.015)
    direct = bm.geodesic_between(body, places[0], places[2]).length
    assert path.field_data["length"][0] > direct + 0.005


def test_clicks_that_measure_nothing_say_so(clicking: Any, body: bm.Atlas, mesh: Any) -> None:
    plotter, paths = clicking
    _press(plotter, (2.0, 0.0, 0.0))
    assert _corner(plotter) == "there is no mesh; click on it"
    # What goes wrong is said in the window, where a traceback would be of no use.
    mesh.points += (0.0, 0.0, 0.01)
    for name in (BUST, "front hip point"):
        _press(plotter, body.position(body.landmarks[name]))
    assert "it was moved, scaled, deformed or cut" in _corner(plotter)
    assert paths == []
