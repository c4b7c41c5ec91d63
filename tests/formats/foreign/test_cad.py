"""STEP and IGES files, written by Open CASCADE."""

import warnings
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ReadWarning
from bodymeasure.formats.foreign import cad_worker

# It takes a second to load, which is spent where these tests run and not where they are listed.
pytestmark = pytest.mark.skipif(find_spec("OCP") is None, reason="needs Open CASCADE")

KINDS = ("step", "iges")


def written(path: Path, shape: Any) -> Path:
    from OCP.IGESControl import IGESControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    if path.suffix == ".step":
        step = STEPControl_Writer()
        step.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
        step.Write(str(path))
    else:
        iges = IGESControl_Writer()
        iges.AddShape(shape)
        iges.Write(str(path))
    return path


def sphere() -> Any:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere
    from OCP.gp import gp_Pnt

    return BRepPrimAPI_MakeSphere(gp_Pnt(1.0, 2.0, 3.0), 20.0).Shape()


def free_form(rng: np.random.Generator) -> tuple[Any, Any]:
    """A face on a bicubic B-spline surface of 2 x 3 patches, and the surface."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.Geom import Geom_BSplineSurface
    from OCP.gp import gp_Pnt

    try:
        from OCP.collections import Array1_double as Reals
        from OCP.collections import Array1_int as Integers
        from OCP.collections import Array2_gp_Pnt as Points
    except ImportError:  # versions of OCP before 8
        from OCP.TColgp import TColgp_Array2OfPnt as Points
        from OCP.TColStd import TColStd_Array1OfInteger as Integers
        from OCP.TColStd import TColStd_Array1OfReal as Reals

    poles = Points(1, 5, 1, 6)
    for i in range(5):
        for j in range(6):
            poles.SetValue(i + 1, j + 1, gp_Pnt(10.0 * i, 10.0 * j, 3.0 * rng.normal()))

    def knots(count: int) -> tuple[Any, Any]:
        values, times = Reals(1, count), Integers(1, count)
        for number in range(count):
            values.SetValue(number + 1, float(number))
            times.SetValue(number + 1, 4 if number in (0, count - 1) else 1)
        return values, times

    (u, times_u), (v, times_v) = knots(3), knots(4)
    surface = Geom_BSplineSurface(poles, u, v, times_u, times_v, 3, 3)
    return BRepBuilderAPI_MakeFace(surface, 1e-6).Face(), surface


@pytest.mark.parametrize("kind", quick(KINDS))
def test_a_sphere_has_diagonals_of_great_circles(kind: str, tmp_path: Path) -> None:
    atlas = bm.read_atlas(written(tmp_path / f"a.{kind}", sphere()))
    assert (atlas.unit, atlas.is_rational) == (bm.Unit.MM, True)
    radii = np.linalg.norm(atlas.points - [1.0, 2.0, 3.0], axis=1)
    assert radii.min() > 20.0 - 1e-9
    nets = atlas.control_points
    corners = np.array([[[0, 0], [1, 0]], [[1, 1], [0, 1]]], dtype=float)
    start, end = (evaluate(nets, np.broadcast_to(c, (len(nets), 2, 2))) for c in corners)
    middle = np.array([1.0, 2.0, 3.0])
    cosine = ((start - middle) * (end - middle)).sum(axis=-1) / 400.0
    np.testing.assert_allclose(bm.diagonals(atlas).length, 20.0 * np.arccos(cosine), rtol=1e-9)


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.filterwarnings("ignore:.*is trimmed:bodymeasure.errors.ReadWarning")
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("top", [0.0, 2.0])
def test_full_turns_are_read_though_rounding_makes_them_a_little_more(
    kind: str, top: float, tmp_path: Path, rng: np.random.Generator
) -> None:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone, BRepPrimAPI_MakeTorus

    cone = BRepPrimAPI_MakeCone(5.0, top, 10.0).Shape()
    atlas = bm.read_atlas(written(tmp_path / f"cone.{kind}", cone))
    # Three patches round, and one for each lid.
    assert len(atlas) == (4 if top == 0.0 else 5)
    round_ = _points(atlas, rng)[:3]
    radius = np.linalg.norm(round_[..., :2], axis=-1)
    np.testing.assert_allclose(radius, 5.0 - (5.0 - top) * round_[..., 2] / 10.0, atol=1e-12)

    segment = BRepPrimAPI_MakeTorus(10.0, 3.0, 1.0).Shape()
    tube = _points(bm.read_atlas(written(tmp_path / f"torus.{kind}", segment)), rng)[:3]
    angle = np.arctan2(tube[..., 1], tube[..., 0])
    assert angle.min() > -1e-9
    assert angle.max() < 1.0 + 1e-9
    off_axis = np.linalg.norm(tube[..., :2], axis=-1) - 10.0
    np.testing.assert_allclose(np.hypot(off_axis, tube[..., 2]), 3.0, atol=1e-12)


def _points(atlas: bm.Atlas, rng: np.random.Generator) -> Array:
    return evaluate(atlas.control_points, rng.uniform(size=(len(atlas), 50, 2)))


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.parametrize("kind", KINDS)
def test_a_free_form_surface_is_the_same_everywhere(
    kind: str, tmp_path: Path, rng: np.random.Generator
) -> None:
    face, surface = free_form(rng)
    atlas = bm.read_atlas(written(tmp_path / f"a.{kind}", face))
    assert len(atlas) == 6
    assert bm.check_atlas(atlas) == ()
    for patch, (row, column) in enumerate(np.ndindex(2, 3)):
        u, v = rng.uniform(size=2)
        point = surface.Value(row + u, column + v)
        found = evaluate(atlas.control_points[patch], (u, v))
        np.testing.assert_allclose(found, [point.X(), point.Y(), point.Z()], atol=1e-9)


@pytest.mark.usefixtures("_in_this_process")
def test_faces_of_a_solid_are_joined_and_face_outwards(tmp_path: Path) -> None:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox

    atlas = bm.read_atlas(
        written(tmp_path / "a.step", BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape())
    )
    assert {finding.kind.name for finding in bm.check_atlas(atlas)} == {"KINKED_SEAM"}
    middle = atlas.points.mean(axis=0)
    from bodymeasure.atlas.normals import normal_vectors

    at = np.full((len(atlas), 2), 0.5)
    outwards = normal_vectors(atlas.control_points, at)
    positions = evaluate(atlas.control_points, at)
    assert (((positions - middle) * outwards).sum(axis=1) > 0.0).all()


@pytest.mark.usefixtures("_in_this_process")
def test_a_trimmed_face_is_named(tmp_path: Path) -> None:
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder

    box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape()
    shape = BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(4.0, 50.0).Shape()).Shape()
    with pytest.warns(ReadWarning, match=r"face \d is trimmed; its underlying surface is taken"):
        bm.read_atlas(written(tmp_path / "a.step", shape))


def plane(degree: int = 1, low: float = 0.0, high: float = 100.0, left: float = 0.0) -> Any:
    """A face on a square B-spline of 100 mm, from `low` to `high` in u, `left` mm along x."""
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakeFace,
        BRepBuilderAPI_MakeWire,
    )
    from OCP.BRepLib import BRepLib
    from OCP.Geom import Geom_BezierSurface
    from OCP.Geom2d import Geom2d_Line
    from OCP.GeomConvert import GeomConvert
    from OCP.gp import gp_Dir2d, gp_Pnt, gp_Pnt2d

    try:
        from OCP.collections import Array2_gp_Pnt as Points
    except ImportError:  # versions of OCP before 8
        from OCP.TColgp import TColgp_Array2OfPnt as Points

    poles = Points(1, degree + 1, 1, 2)
    for i in range(degree + 1):
        for j in range(2):
            poles.SetValue(i + 1, j + 1, gp_Pnt(left + 100.0 * i / degree, 100.0 * j, 0.0))
    convert = cad_worker._static(GeomConvert, "SurfaceToBSplineSurface")
    surface = convert(Geom_BezierSurface(poles))
    low, high = low / 100.0, high / 100.0
    wire = BRepBuilderAPI_MakeWire()
    corners = [(low, 0.0), (high, 0.0), (high, 1.0), (low, 1.0)]
    for (u, v), (next_u, next_v) in zip(corners, corners[1:] + corners[:1], strict=True):
        length = abs(next_u - u) + abs(next_v - v)
        along = gp_Dir2d((next_u - u) / length, (next_v - v) / length)
        line = Geom2d_Line(gp_Pnt2d(u, v), along)
        wire.Add(BRepBuilderAPI_MakeEdge(line, surface, 0.0, length).Edge())
    face = BRepBuilderAPI_MakeFace(surface, wire.Wire(), True).Face()
    cad_worker._static(BRepLib, "BuildCurves3d")(face)
    return face


def compound(*shapes: Any) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    whole, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(whole)
    for shape in shapes:
        builder.Add(whole, shape)
    return whole


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.parametrize(("low", "high"), [(-0.005, 100.0), (0.0, 101.0), (-2.0, 100.5)])
def test_a_face_that_overhangs_its_surface_ends_where_it_does(
    low: float, high: float, tmp_path: Path
) -> None:
    path = written(tmp_path / "a.step", compound(plane(low=low, high=high), plane(left=100.0)))
    with pytest.warns(ReadWarning, match=r"face 1 runs past the border of its surface by .* taken"):
        atlas = bm.read_atlas(path)
    assert len(atlas) == 2
    np.testing.assert_allclose(atlas.control_points[0].min(axis=(0, 1)), 0.0, atol=1e-9)
    np.testing.assert_allclose(atlas.control_points[0].max(axis=(0, 1)), [100, 100, 0], atol=1e-9)
    # The neighbor is joined.
    assert {finding.kind.name for finding in bm.check_atlas(atlas)} == set()


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.parametrize("kind", KINDS)
def test_a_face_of_too_high_a_degree_is_named_and_left_out(kind: str, tmp_path: Path) -> None:
    path = written(tmp_path / f"a.{kind}", compound(plane(), plane(degree=13, left=200.0)))
    with pytest.warns(ReadWarning, match=r"face 2: has the degrees 13 and 1; only .* left out"):
        atlas = bm.read_atlas(path)
    assert len(atlas) == 1
    alone = written(tmp_path / f"b.{kind}", plane(degree=13))
    with pytest.raises(bm.InputError, match=r"b\..*, face 1: has the degrees 13 and 1; only"):
        bm.read_atlas(alone)


@pytest.mark.usefixtures("_in_this_process")
def test_a_face_that_cannot_be_converted_is_named_and_left_out(tmp_path: Path) -> None:
    # Wholly beside its surface.
    path = written(tmp_path / "a.step", compound(plane(low=101.0, high=102.0), plane(left=100.0)))
    with pytest.warns(ReadWarning, match=r"face 1 cannot be made a B-spline \(.*\); it is left"):
        assert len(bm.read_atlas(path)) == 1


@pytest.mark.parametrize("kind", quick(KINDS))
@pytest.mark.parametrize(
    "content",
    [
        b"ISO-10303-21;\nno more",
        *(pytest.param(each, marks=pytest.mark.slow) for each in (b"", b"\x00\xff" * 100)),
    ],
)
def test_what_cannot_be_read_is_refused(kind: str, content: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"bad.{kind}"
    path.write_bytes(content)
    with pytest.raises(bm.InputError, match=rf"bad\.{kind}: (is no .* file|holds no patch)"):
        bm.read_atlas(path)


def test_a_file_that_takes_too_long_is_given_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from bodymeasure.formats.foreign import cad

    path = written(tmp_path / "a.step", sphere())
    monkeypatch.setattr(cad, "LONGEST", 1e-3)
    with pytest.raises(
        bm.InputError, match=r"a\.step: Open CASCADE did not read it in 0 s; it may"
    ):
        bm.read_atlas(path)


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("is_reversed", [False, True])
def test_parameters_of_a_face_are_those_of_its_surface(
    kind: str, is_reversed: bool, tmp_path: Path, rng: np.random.Generator
) -> None:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    face, surface = free_form(rng)
    builder, both = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(both)
    builder.Add(both, face.Reversed() if is_reversed else face)
    builder.Add(both, sphere())
    atlas = bm.read_atlas(written(tmp_path / f"a.{kind}", both))
    assert atlas.faces is not None
    # An IGES file has the sphere first.
    (own,) = {name for name in atlas.faces.names if name}
    (converted,) = atlas.faces.without
    assert {own, converted} == {"face 1", "face 2"}
    for s, t in [*rng.uniform([0.0, 0.0], [2.0, 3.0], (20, 2)).tolist(), (2.0, 0.0), (1.0, 2.0)]:
        # Open CASCADE turns a reversed surface around itself when it writes an IGES file.
        point = surface.Value(2.0 - s if is_reversed and kind == "iges" else s, t)
        found = atlas.position(atlas.parameters(own, s, t))
        np.testing.assert_allclose(found, [point.X(), point.Y(), point.Z()], atol=1e-9)
    with pytest.raises(bm.InputError, match=f"{converted} has no parameters: its surface was"):
        atlas.parameters(converted, 0.1, 0.1)


@pytest.mark.usefixtures("_in_this_process")
@pytest.mark.parametrize("angle", [0.5, np.pi / 2, np.pi, 2.0 * np.pi])
def test_a_round_face_has_no_parameters(angle: float, tmp_path: Path) -> None:
    """The surface and its spline have the same points in the middles of arcs, and no others."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder

    shape = BRepPrimAPI_MakeCylinder(5.0, 10.0, angle).Shape()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ReadWarning)
        atlas = bm.read_atlas(written(tmp_path / "a.step", shape))
    assert atlas.faces is not None
    assert len(atlas.faces.without) == 1
