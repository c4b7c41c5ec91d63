"""Rhino's files, written by rhino3dm."""

import uuid
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.atlas.normals import normal_vectors
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ReadWarning
from bodymeasure.formats.foreign import rhino_objects

rhino3dm: Any = pytest.importorskip("rhino3dm")

# A process of its own for each file takes half a second. Sound files need none.
QUICKLY = pytest.mark.usefixtures("_in_this_process")
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


@QUICKLY
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


@QUICKLY
def test_faces_of_a_solid_are_joined(tmp_path: Path) -> None:
    box = rhino3dm.Box(rhino3dm.BoundingBox(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 2, 3)))
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", rhino3dm.Brep.CreateFromBox(box)))
    assert len(atlas) == 6
    kinds = {finding.kind.name for finding in bm.check_atlas(atlas)}
    # All seams are joined and all faces point outwards: the only findings are the kinks of the
    # edges.
    assert kinds == {"KINKED_SEAM"}


@QUICKLY
def test_a_trimmed_face_is_named_and_taken_whole(tmp_path: Path) -> None:
    circle = rhino3dm.Circle(rhino3dm.Point3d(0.5, 0.5, 0.0), 0.3).ToNurbsCurve()
    disk = rhino3dm.Brep.CreateTrimmedPlane(rhino3dm.Plane.WorldXY(), circle)
    path = written(tmp_path / "a.3dm", disk)
    with pytest.warns(ReadWarning, match=r"object 0 is trimmed; its whole underlying surface"):
        atlas = bm.read_atlas(path)
    assert len(atlas) == 1


@QUICKLY
def test_what_has_no_surface_is_named_and_left_out(tmp_path: Path) -> None:
    line = rhino3dm.LineCurve(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 0, 0))
    path = written(tmp_path / "a.3dm", line, sphere(1.0))
    with pytest.warns(ReadWarning, match=r"object 0 is a LineCurve, which has no NURBS surface"):
        assert len(bm.read_atlas(path)) == 8


@QUICKLY
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


@pytest.mark.slow
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


def flat(name: str, *, layer: int = 0, z: float = 0.0, visible: bool = True) -> tuple[Any, Any]:
    """A unit square, and its attributes."""
    surface = rhino3dm.NurbsSurface.Create(3, False, 2, 2, 2, 2)
    for i, j in np.ndindex(2, 2):
        surface.Points[(i, j)] = rhino3dm.Point4d(i, j, z, 1.0)
    surface.KnotsU.CreateUniformKnots(1.0)
    surface.KnotsV.CreateUniformKnots(1.0)
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name, attributes.LayerIndex, attributes.Visible = name, layer, visible
    return surface, attributes


def block(file: Any, name: str, *members: tuple[Any, Any]) -> Any:
    """Add the definition of a block, and return its identifier."""
    geometry, attributes = zip(*members, strict=True)
    origin = rhino3dm.Point3d(0, 0, 0)
    number = file.InstanceDefinitions.Add(name, "", "", "", origin, geometry, attributes)
    return file.InstanceDefinitions.FindIndex(number).Id


def instance(identifier: Any, *transforms: Any, name: str = "") -> tuple[Any, Any]:
    """An instance of a block, to which the transforms are done from the last to the first."""
    total = rhino3dm.Transform.Identity()
    for transform in transforms:
        total = rhino3dm.Transform.Multiply(total, transform)
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name = name
    return rhino3dm.InstanceReference(identifier, total), attributes


def model() -> Any:
    file = rhino3dm.File3dm()
    file.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Centimeters
    return file


MOVE = rhino3dm.Transform.Translation(100.0, 0.0, 0.0)
TWICE = rhino3dm.Transform.Scale(rhino3dm.Point3d(0, 0, 0), 2.0)
TURN = rhino3dm.Transform.Rotation(
    0.5 * np.pi, rhino3dm.Vector3d(0, 0, 1), rhino3dm.Point3d(0, 0, 0)
)
MIRROR = rhino3dm.Transform.Mirror(rhino3dm.Point3d(0, 0, 0), rhino3dm.Vector3d(1, 0, 0))


def extent(atlas: bm.Atlas) -> list[list[float]]:
    points = atlas.control_points.reshape(len(atlas), -1, 3)
    corners: list[list[float]] = np.round(
        np.concatenate([points.min(axis=1), points.max(axis=1)], 1), 12
    ).tolist()
    return corners


@QUICKLY
def test_blocks_are_read_where_they_are_placed(tmp_path: Path) -> None:
    file = model()
    square = block(file, "square", flat("cuff"))
    pair = block(file, "pair", instance(square), instance(square, MOVE, name="far"))
    file.Objects.Add(*instance(square, MOVE, TWICE, name="sleeve"))
    file.Objects.Add(*instance(pair, TURN))
    file.Write(str(tmp_path / "a.3dm"), 7)
    atlas = bm.read_atlas(tmp_path / "a.3dm")
    assert extent(atlas) == [[100, 0, 0, 102, 2, 0], [-1, 0, 0, 0, 1, 0], [-1, 100, 0, 0, 101, 0]]
    assert atlas.patch_names == ("sleeve cuff", "cuff", "far cuff")


@QUICKLY
def test_solids_in_blocks_that_are_mirrored_face_outwards(tmp_path: Path) -> None:
    file = model()
    ball = block(file, "ball", (sphere(2.0), rhino3dm.ObjectAttributes()))
    file.Objects.Add(*instance(ball, MIRROR))
    file.Write(str(tmp_path / "a.3dm"), 7)
    atlas = bm.read_atlas(tmp_path / "a.3dm")
    at = np.full((len(atlas), 2), 0.5)
    outwards = evaluate(atlas.control_points, at) - [-1.0, 2.0, 3.0]
    np.testing.assert_allclose(np.linalg.norm(outwards, axis=1), 2.0, rtol=1e-14)
    normals = normal_vectors(atlas.control_points, at)
    assert ((normals * outwards).sum(axis=1) > 0.0).all()


@QUICKLY
def test_what_rhino_does_not_show_is_counted_and_named(tmp_path: Path) -> None:
    file = model()
    shown, off, under = (rhino3dm.Layer() for _ in range(3))
    shown.Name, off.Name, under.Name = "shown", "off", "under it"
    off.Visible = False
    file.Layers.Add(shown)
    number = file.Layers.Add(off)
    under.ParentLayerId = file.Layers[number].Id
    file.Layers.Add(under)
    mixed = block(file, "mixed", flat("in", z=7.0), flat("lining", layer=1, z=8.0))
    file.Objects.Add(*flat("old", visible=False))
    file.Objects.Add(*flat("parked", layer=1, z=1.0))
    file.Objects.Add(*flat("deeper", layer=2, z=2.0))
    file.Objects.Add(*flat("body", z=5.0))
    file.Objects.Add(*instance(mixed))
    file.Write(str(tmp_path / "a.3dm"), 7)
    with pytest.warns(ReadWarning) as caught:
        atlas = bm.read_atlas(tmp_path / "a.3dm")
    assert sorted(atlas.points[:, 2].round(12).tolist()) == [5.0] * 16 + [7.0] * 16
    (message,) = (str(warning.message) for warning in caught)
    assert "4 objects are not shown in Rhino and left out: " in message
    for part in (
        "('old') is hidden",
        "('parked') on the layer 'off', which is off",
        "('deeper') on the layer 'off', which is off",
        "('lining') on the layer 'off'",
    ):
        assert part in message


@QUICKLY
def test_a_file_that_shows_nothing_is_refused_with_the_reason(tmp_path: Path) -> None:
    file = model()
    file.Objects.Add(*flat("old", visible=False))
    file.Write(str(tmp_path / "a.3dm"), 7)
    with pytest.raises(bm.InputError, match=r"holds no patch; .*: 1 object is not .* \('old'\) is"):
        bm.read_atlas(tmp_path / "a.3dm")


def test_a_block_that_holds_itself_is_left_out() -> None:
    identifiers = [uuid.UUID(int=number) for number in range(3)]
    items = []
    for number, (geometry, attributes) in enumerate([instance(identifiers[0])] * 2):
        attributes = SimpleNamespace(
            Id=identifiers[number + 1],
            Name="",
            Visible=True,
            Mode=attributes.Mode,
            LayerIndex=0,
            IsInstanceDefinitionObject=number == 0,
        )
        items.append(SimpleNamespace(Geometry=geometry, Attributes=attributes))
    definition = SimpleNamespace(Id=identifiers[0], GetObjectIds=lambda: identifiers[1:2])
    file = SimpleNamespace(Objects=items, InstanceDefinitions=[definition], Layers=[])
    found, notes = rhino_objects.seen_objects(file)
    assert found == []
    assert notes == [
        "object 0 places a block that holds itself or lies more than 64 deep; it is left out"
    ]


@QUICKLY
def test_blocks_without_objects_are_named(tmp_path: Path) -> None:
    file = model()
    missing = uuid.UUID(int=7)
    file.Objects.Add(*flat("body"))
    file.Objects.Add(*instance(missing, name="trim"))
    file.Write(str(tmp_path / "a.3dm"), 7)
    with pytest.warns(ReadWarning, match=r"object 1 \('trim'\) places a block that has no objects"):
        assert len(bm.read_atlas(tmp_path / "a.3dm")) == 1


def test_the_members_of_nested_blocks_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    file = model()
    inner = block(file, "0", flat("one"))
    for level in range(1, 30):
        inner = block(file, str(level), instance(inner), instance(inner))
    file.Objects.Add(*instance(inner))
    monkeypatch.setattr(rhino_objects, "MOST_PLACED", 1000)
    found, notes = rhino_objects.seen_objects(file)
    assert len(found) < 1000
    assert notes == ["blocks place more than 1,000 objects; the others are left out"]


@QUICKLY
@READS
def test_parameters_of_an_object_are_those_of_its_surface(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    surface = free_form(rng)
    box = rhino3dm.Box(rhino3dm.BoundingBox(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 2, 3)))
    solid = rhino3dm.Brep.CreateFromBox(box)
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", surface, solid, sphere(2.0)))
    assert atlas.faces is not None
    names = list(dict.fromkeys(name for name in atlas.faces.names if name))
    assert len(names) == 7
    for name, each in zip(names, [surface, *(solid.Faces[k] for k in range(6))], strict=True):
        for fractions in [*rng.uniform(size=(5, 2)).tolist(), (1.0, 0.0), (1 / 3, 0.5)]:
            s, t = (
                each.Domain(k).T0 + part * (each.Domain(k).T1 - each.Domain(k).T0)
                for k, part in enumerate(fractions)
            )
            point = each.PointAt(s, t)
            found = atlas.position(atlas.parameters(name, s, t))
            np.testing.assert_allclose(found, [point.X, point.Y, point.Z], atol=1e-12)
    (other,) = atlas.faces.without
    with pytest.raises(bm.InputError, match="its surface was converted to a B-spline"):
        atlas.parameters(other, 0.5, 0.5)


@QUICKLY
@READS
def test_a_round_face_has_no_parameters(tmp_path: Path) -> None:
    """The surface and its spline have the same points at each eighth of a turn, and no others."""
    round_ = rhino3dm.Cylinder(rhino3dm.Circle(1.0), 2.0).ToBrep(True, True)
    atlas = bm.read_atlas(written(tmp_path / "a.3dm", round_))
    assert atlas.faces is not None
    assert list(atlas.faces.without) == ["object 0, face 0"]
