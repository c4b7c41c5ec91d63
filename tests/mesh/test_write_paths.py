"""Paths as curves in files, read again by other libraries, and as near as is said."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import BSpline

import bodymeasure as bm
from bodymeasure._typing import Array

pytest.importorskip("igl")
NAME = "nape, 'left' \u00fc"
SQUARE = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]])


@pytest.fixture(scope="module")
def path() -> bm.AtlasPath:
    body = bm.load_sample("female_average")
    return bm.geodesic_between(body, "back neck point", "bust point left")


def nearest(points: Array, path: bm.AtlasPath) -> float:
    """How far points are from a path at most."""
    fine = path.position(np.linspace(0.0, 1.0, 2_001))
    return float(max(np.linalg.norm(fine - point, axis=1).min() for point in points))


def test_json_holds_the_spline(path: bm.AtlasPath, tmp_path: Path) -> None:
    file = tmp_path / "paths.json"
    bm.write_paths(file, path.atlas, {NAME: path, "square": SQUARE})
    content = json.loads(file.read_bytes())
    smooth, straight = content["paths"]
    assert (content["unit"], smooth["name"], smooth["degree"]) == ("m", NAME, 3)
    assert smooth["length"] == path.length
    assert smooth["status"] == "converged"
    spline = BSpline(smooth["knots"], np.array(smooth["control_points"]), 3)
    t = np.linspace(0.0, 1.0, 5_001)
    off = np.linalg.norm(spline(t) - path.position(t), axis=1).max()
    assert off <= 2e-7 * path.length
    length = np.linalg.norm(np.diff(spline(np.linspace(0.0, 1.0, 20_001)), axis=0), axis=1).sum()
    assert length == pytest.approx(path.length, rel=1e-6)
    assert straight["degree"] == 1
    assert straight["points"] == SQUARE.tolist()


def test_rhino_reads_its_file(path: bm.AtlasPath, tmp_path: Path) -> None:
    rhino3dm: Any = pytest.importorskip("rhino3dm")
    file = tmp_path / "paths.3dm"
    bm.write_paths(file, path.atlas, {NAME: path, "square": SQUARE})
    model = rhino3dm.File3dm.Read(str(file))
    assert model.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Meters
    assert [item.Attributes.Name for item in model.Objects] == [NAME, "square"]
    curve = model.Objects[0].Geometry
    assert curve.IsValid
    points = [curve.PointAt(t) for t in np.linspace(0.0, 1.0, 9)]
    found = np.array([[p.X, p.Y, p.Z] for p in points])
    assert found == pytest.approx(path.position(np.linspace(0.0, 1.0, 9)), abs=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("unit", ["m", "inch"])
def test_open_cascade_reads_the_step_file(path: bm.AtlasPath, unit: str, tmp_path: Path) -> None:
    pytest.importorskip("OCP")
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    from bodymeasure.formats.foreign.cad_worker import _static

    file = tmp_path / "paths.step"
    atlas = path.atlas.converted(unit)
    scale = path.atlas.unit.meters / atlas.unit.meters
    bm.write_paths(file, atlas, {NAME: scale * path.position(np.linspace(0.0, 1.0, 9))})
    reader: Any = STEPControl_Reader()
    reader.ReadFile(str(file))
    reader.TransferRoots()
    from OCP.BRepAdaptor import BRepAdaptor_Curve

    explorer: Any = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_EDGE)
    ends = []
    while explorer.More():
        curve: Any = BRepAdaptor_Curve(_static(TopoDS, "Edge")(explorer.Current()))
        ends += [curve.Value(curve.FirstParameter()), curve.Value(curve.LastParameter())]
        explorer.Next()
    # Open CASCADE reads everything in millimeters.
    found = np.array([[p.X(), p.Y(), p.Z()] for p in ends])
    assert found[0] == pytest.approx(1000.0 * path.position(0.0), abs=1e-6)
    assert found[-1] == pytest.approx(1000.0 * path.position(1.0), abs=1e-6)


def test_step_is_text_with_the_names(path: bm.AtlasPath, tmp_path: Path) -> None:
    file = tmp_path / "paths.stp"
    bm.write_paths(file, path.atlas, {NAME: path})
    text = file.read_text("ascii")
    assert "'nape, ''left'' \\X4\\000000FC\\X0\\'" in text
    numbers = re.findall(r"^#(\d+)=", text, re.M)
    assert len(set(numbers)) == len(numbers)
    assert set(re.findall(r"#(\d+)", text)) == set(numbers)


def test_obj_and_svg_have_the_points(path: bm.AtlasPath, tmp_path: Path) -> None:
    file = tmp_path / "paths.obj"
    bm.write_paths(file, path.atlas, {"a b": path, "square": SQUARE})
    lines = file.read_text().splitlines()
    points = np.array(
        [[float(x) for x in line.split()[1:]] for line in lines if line.startswith("v ")]
    )
    chains = [[int(x) for x in line.split()[1:]] for line in lines if line.startswith("l ")]
    assert [line for line in lines if line.startswith("o ")] == ["o a b", "o square"]
    assert sum(map(len, chains)) == len(points)
    assert nearest(points[np.array(chains[0]) - 1], path) < 1e-4
    drawing = tmp_path / "paths.svg"
    bm.write_paths(drawing, path.atlas, {"a": path, "square": SQUARE})
    text = drawing.read_text()
    assert text.count("<path id=") == 2
    start = re.search(r'id="a" d="M ([-\d.]+),([-\d.]+) C', text)
    assert start is not None
    x, _, z = (1000.0 * path.position(0.0)).tolist()
    # The wearer's left is on the right of the front view.
    assert [float(each) for each in start.groups()] == pytest.approx([x, -z], abs=1e-4)


@pytest.mark.parametrize(
    ("file", "paths", "words"),
    [
        ("a.iges", {"a": SQUARE}, "expected a name that ends in one of .3dm, .step"),
        ("a.step", {"a": SQUARE[:1]}, "has 1 point; expected two or more"),
        ("a.step", {}, "there is no path with a length"),
        ("a.step", {"a": SQUARE[[0, 0]]}, "there is no path with a length"),
        ("a.step", {"a": "b"}, "is no path"),
    ],
)
def test_bad_input_is_refused(file: str, paths: Any, words: str, tmp_path: Path) -> None:
    with pytest.raises(bm.InputError, match=words):
        bm.write_paths(tmp_path / file, bm.load_sample("paraboloid"), paths)
    assert list(tmp_path.iterdir()) == []
