"""`bodymeasure landmarks add` by the vertices of a mesh, and from a file of positions."""

from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run, hide_here

from bodymeasure import read_atlas
from bodymeasure.atlas import AtlasPoint, Unit

BUST = ("9.1", "-16", "116.4")


def test_vertices_are_counted_from_0_or_from_1(run: Run, bare: Path, tmp_path: Path) -> None:
    body = read_atlas(bare)
    places = [AtlasPoint(10, 0.2, 0.3), AtlasPoint(200, 0.5, 0.5), AtlasPoint(300, 0.9, 0.1)]
    positions = np.array([body.position(place) for place in places]) / Unit.INCH.meters
    mesh = tmp_path / "body.obj"
    lines = ["# a mesh", *(f"v {x!r} {y!r} {z!r} 1" for x, y, z in positions.tolist())]
    mesh.write_text("\n".join([*lines, "vt 0 0", "vn 1 0 0", "f 1/1/1 2/1/1 3/1/1"]), "utf-8")
    name = "elbow point left"
    for options, place in ((("1",), places[1]), (("3", "--from-one"), places[2])):
        ran = run(
            "landmarks", "add", bare, name, "--mesh", mesh, "--position-unit", "inch", "--in-place",
            "--replace", "--vertex", *options,
        )  # fmt: skip
        assert (ran.code, ran.err) == (0, "")
        found = read_atlas(bare).landmarks[name]
        assert found.patch == place.patch
        assert (found.u, found.v) == pytest.approx((place.u, place.v), abs=1e-9)
    for options, message in (
        (("3",), "has no vertex 3: its 3 vertices are numbered from 0 to 2 (or give --from-one"),
        (("0", "--from-one"), "has no vertex 0: its 3 vertices are numbered from 1 to 3\n"),
        (("-1",), "has no vertex -1"),
    ):
        ran = run(
            "landmarks", "add", bare, "x", "--mesh", mesh, "--position-unit", "inch", "--in-place",
            "--vertex", *options,
        )  # fmt: skip
        assert (ran.code, ran.out) == (2, "")
        assert message in ran.err


@pytest.mark.parametrize("suffix", [".ply", ".off"])
def test_other_meshes_are_read_by_trimesh(
    run: Run, bare: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str
) -> None:
    trimesh = pytest.importorskip("trimesh")
    body = read_atlas(bare)
    corners = [body.position(AtlasPoint(40, u, v)) for u, v in ((0.1, 0.1), (0.9, 0.2), (0.4, 0.8))]
    mesh = tmp_path / f"body{suffix}"
    trimesh.Trimesh(corners, [[0, 1, 2]], process=False).export(mesh)
    arguments = (
        "landmarks", "add", bare, "elbow point left", "--mesh", mesh, "--vertex", "2",
        "--position-unit", "m", "--in-place",
    )  # fmt: skip
    assert run(*arguments).code == 0
    found = read_atlas(bare).landmarks["elbow point left"]
    # Such files hold some eight digits.
    assert found.patch == 40
    assert (found.u, found.v) == pytest.approx((0.4, 0.8), abs=1e-5)
    mesh.write_bytes(b"nonsense")
    ran = run(*arguments, "--replace")
    assert ran.code == 2
    assert f"body{suffix}: cannot be read as a mesh" in ran.err
    hide_here(monkeypatch, "trimesh")
    ran = run(*arguments, "--replace")
    assert ran.code == 2
    assert f"reading {suffix} files needs the package 'trimesh'" in ran.err


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("gone.obj", None, "gone.obj: no such file; check the path"),
        ("body.stl", "", "body.stl: unknown kind of mesh '.stl'; expected one of .obj, .off, .ply"),
        ("body.obj", "v 1 2\n", "body.obj, line 1: a vertex of 2 numbers; expected v x y z"),
        ("body.obj", "f 1 2 3\n", "body.obj: holds no vertex; expected a mesh"),
        ("body.obj", "v nan 0 0\n", "body.obj, line 1: 'nan' is not a finite number; expected"),
    ],
)
def test_bad_meshes_are_told(
    run: Run, bare: Path, tmp_path: Path, name: str, content: str | None, message: str
) -> None:
    mesh = tmp_path / name
    if content is not None:
        mesh.write_text(content, "utf-8")
    ran = run(
        "landmarks", "add", bare, "x", "--mesh", mesh, "--vertex", "0",
        "--position-unit", "m", "--in-place"
    )  # fmt: skip
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err


@pytest.mark.parametrize("header", ["", "\ufeffName, x, y, z\n"])
def test_several_are_added_from_a_file(run: Run, bare: Path, tmp_path: Path, header: str) -> None:
    picks = tmp_path / "picks.csv"
    rows = f'{header}bust point left,{",".join(BUST)}\n\n"bust point right",-9.1,-16,1.164e2\n'
    picks.write_text(rows, "utf-8")
    new = tmp_path / "new.atlas"
    ran = run("landmarks", "add", bare, "--from", picks, "--position-unit", "cm", "-o", new)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.endswith(f"{new}: 3 landmarks\n")
    atlas = read_atlas(new)
    left, right = (
        atlas.position(atlas.landmarks[f"bust point {side}"]) for side in ("left", "right")
    )
    np.testing.assert_allclose(left, right * [-1.0, 1.0, 1.0], rtol=0.0, atol=1e-12)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "picks.csv: holds no landmark; expected lines such as"),
        ("name,x,y,z\n", "picks.csv: holds no landmark"),
        ("a,0,0,1\nb,0,0\n", "picks.csv, line 2: is 'b, 0, 0'; expected name, x, y, z: a name and"),
        ("a,0,0,one\n", "picks.csv, line 1: is 'a, 0, 0, one'"),
        ("a;0,1;0,2;0,3\n", "separate them by commas, with points in numbers"),
        ('a,"0"1,0,0\n', "picks.csv, line 1: is no CSV"),
        ("a,0,inf,0\n", "landmark 'a' is [0.0, inf, 0.0]; expected three finite numbers"),
        ("a,0.0,-15,97.6\na,0.0,-15,97.6\n", "landmark 'a' is given twice; expected it once"),
        (",0.0,-15,97.6\n", "is to be named ''; expected a name on one line"),
        ("a,0.0,-15,976\n", "landmark 'a' at (0, -15, 976) cm is 83"),
        (b"\xff\xfe", "picks.csv: is not text in UTF-8; save it as CSV in UTF-8"),
    ],
)
def test_bad_files_of_picks_are_told(
    run: Run, bare: Path, tmp_path: Path, content: str | bytes, message: str
) -> None:
    picks = tmp_path / "picks.csv"
    picks.write_bytes(content if isinstance(content, bytes) else content.encode())
    before = bare.read_bytes()
    ran = run("landmarks", "add", bare, "--from", picks, "--position-unit", "cm", "--in-place")
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert bare.read_bytes() == before
