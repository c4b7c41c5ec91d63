"""Rhino's files, written by rhino3dm."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ReadWarning

rhino3dm: Any = pytest.importorskip("rhino3dm")

READS = pytest.mark.filterwarnings("ignore::bodymeasure.errors.ReadWarning")


def written(path: Path, *geometry: Any, unit: str = "Centimeters", name: str = "") -> Path:
    file = rhino3dm.File3dm()
    file.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, unit)
    for item in geometry:
        attributes = rhino3dm.ObjectAttributes()
        attributes.Name = name
        file.Objects.Add(item, attributes)
    file.Write(str(path), 7)
    return path


def free_form(rng: np.random.Generator) -> Any:
    """A cubic B-spline surface of 3 x 4 patches."""
    surface = rhino3dm.NurbsSurface.Create(3, False, 4, 4, 6, 7)
    for i in range(6):
        for j in range(7):
            surface.Points[(i, j)] = rhino3dm.Point4d(i, j, 0.3 * rng.normal(), 1.0)
    surface.KnotsU.CreateUniformKnots(1.0)
    surface.KnotsV.CreateUniformKnots(1.0)
    return surface


def sphere(radius: float) -> Any:
    return rhino3dm.Sphere(rhino3dm.Point3d(1.0, 2.0, 3.0), radius).ToBrep()


def test_a_sphere_has_diagonals_of_a_quarter_of_its_circles(tmp_path: Path) -> None:
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", sphere(2.0), name="head"))
    assert (len(atlas), atlas.unit, atlas.is_rational) == (8, bm.Unit.CM, True)
    assert all(name.startswith("head") for name in atlas.patch_names)
    np.testing.assert_allclose(bm.diagonals(atlas).length, np.pi, rtol=1e-10)
    kinds = {finding.kind.name for finding in bm.check_atlas(atlas)}
    assert kinds == {"COLLAPSED_EDGE"}


def test_a_free_form_surface_is_the_same_everywhere(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    surface = free_form(rng)
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", surface))
    assert len(atlas) == 12
    assert bm.check_atlas(atlas) == ()
    domains = [surface.Domain(axis) for axis in (0, 1)]
    for patch, (row, column) in enumerate(np.ndindex(3, 4)):
        u, v = rng.uniform(size=2)
        point = surface.PointAt(
            domains[0].T0 + (row + u) / 3 * (domains[0].T1 - domains[0].T0),
            domains[1].T0 + (column + v) / 4 * (domains[1].T1 - domains[1].T0),
        )
        expected = [point.X, point.Y, point.Z]
        found = evaluate(atlas.control_points[patch], (u, v))
        np.testing.assert_allclose(found, expected, atol=1e-12)


def test_faces_of_a_solid_are_joined(tmp_path: Path) -> None:
    box = rhino3dm.Box(rhino3dm.BoundingBox(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 2, 3)))
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", rhino3dm.Brep.CreateFromBox(box)))
    assert len(atlas) == 6
    kinds = {finding.kind.name for finding in bm.check_atlas(atlas)}
    # All seams are joined and all faces point outwards: the only findings are the kinks of the
    # edges.
    assert kinds == {"KINKED_SEAM"}


def test_a_trimmed_face_is_named_and_taken_whole(tmp_path: Path) -> None:
    circle = rhino3dm.Circle(rhino3dm.Point3d(0.5, 0.5, 0.0), 0.3).ToNurbsCurve()
    disk = rhino3dm.Brep.CreateTrimmedPlane(rhino3dm.Plane.WorldXY(), circle)
    path = written(tmp_path / "a.3dm", disk)
    with pytest.warns(ReadWarning, match=r"object 0 is trimmed; its whole underlying surface"):
        atlas = bm.read_atlas(path)
    assert len(atlas) == 1


def test_what_has_no_surface_is_named_and_left_out(tmp_path: Path) -> None:
    line = rhino3dm.LineCurve(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 0, 0))
    path = written(tmp_path / "a.3dm", line, sphere(1.0))
    with pytest.warns(ReadWarning, match=r"object 0 is a LineCurve, which has no NURBS surface"):
        assert len(bm.read_atlas(path)) == 8


@READS
def test_bad_files_and_units_are_refused(tmp_path: Path) -> None:
    (tmp_path / "bad.3dm").write_bytes(b"3D Geometry File Format but no more")
    with pytest.raises(bm.InputError, match=r"bad\.3dm: is no 3dm file that rhino3dm can read"):
        bm.read_atlas(tmp_path / "bad.3dm")
    feet = written(tmp_path / "feet.3dm", sphere(1.0), unit="Feet")
    with pytest.raises(bm.InputError, match=r"feet\.3dm: is in Feet; expected one of Millimeters"):
        bm.read_atlas(feet)
    none = written(tmp_path / "none.3dm", sphere(1.0), unit="None")
    with pytest.raises(bm.InputError, match=r"none\.3dm: .*says no unit"):
        bm.read_atlas(none)
    assert bm.read_atlas(none, unit="inch").unit is bm.Unit.INCH
    centimeters = written(tmp_path / "cm.3dm", sphere(1.0))
    with pytest.raises(bm.InputError, match=r"is in cm, but the unit m was given"):
        bm.read_atlas(centimeters, unit="m")
    empty = written(tmp_path / "empty.3dm")
    with pytest.raises(bm.InputError, match=r"empty\.3dm: holds no patch"):
        bm.read_atlas(empty)


@READS
def test_files_that_were_cut_off_do_no_harm(tmp_path: Path, rng: np.random.Generator) -> None:
    content = written(tmp_path / "a.3dm", sphere(1.0), free_form(rng)).read_bytes()
    path = tmp_path / "b.3dm"
    for length in np.linspace(0, len(content) - 1, 6).astype(int):
        path.write_bytes(content[:length])
        try:
            atlas = bm.read_atlas(path)
        except bm.InputError:
            continue
        assert np.isfinite(atlas.control_points).all()
