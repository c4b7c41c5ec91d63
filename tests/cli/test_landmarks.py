"""`bodymeasure landmarks`: list, add, remove, check."""

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run, hide_here

from bodymeasure import load_sample, read_atlas, write_atlas
from bodymeasure.atlas import AtlasPoint, Unit

BUST = ("9.1", "-16", "116.4")
SET = """
format = "bodymeasure measurements"
version = 1
name = "Mine"
[[landmark]]
name = "waist point {side}"
rule = "level"
of = "front waist point"
facing = "{side}"
[[landmark]]
name = "chin point"
rule = "level"
of = "top of head"
facing = "front"
[[measurement]]
key = "waist"
kind = "girth"
name = "Waist"
at = "waist point left"
[[measurement]]
key = "face"
kind = "chord"
name = "Face"
start = "chin point"
end = "top of head"
"""


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(SET, "utf-8")
    return path


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """A body of which a single landmark is picked, in a file of its own."""
    body = load_sample("female_average")
    kept = {"front waist point": body.landmarks["front waist point"]}
    path = tmp_path / "bare.atlas"
    write_atlas(replace(body, landmarks=kept), path)
    return path


def words(text: str) -> str:
    return " ".join(text.split())


def test_the_list_tells_what_is_there_what_is_not_and_why(run: Run, bare: Path, mine: Path) -> None:
    ran = run("landmarks", bare, "--set", mine, "--unit", "mm")
    assert (ran.code, ran.err) == (0, "")
    lines = ran.out.splitlines()
    assert lines[0].split() == ["landmark", "patch", "u", "v", "x/mm", "y/mm", "z/mm", "origin"]
    assert lines[1].split()[-6:] == ["0.0494", "1.0000", "0.0", "-150.5", "975.7", "picked"]
    assert lines[2].startswith("waist point left ")
    assert lines[2].endswith("outermost to the left at the height of front waist point")
    assert (
        "chin point: it needs 'top of head', which the atlas lacks and no rule gives; pick it"
        in ran.out
    )
    assert "Lacking for measurements of “Mine”:\n  Face: chin point, top of head\n" in ran.out
    assert run("landmarks", "list", bare, "--set", mine, "--unit", "mm") == ran


def test_the_list_as_json_and_csv(run: Run, bare: Path, mine: Path) -> None:
    ran = run("landmarks", bare, "--set", mine, "--format", "json", "--unit", "m")
    assert (ran.code, ran.err) == (0, "")
    document = json.loads(ran.out)
    assert (document["unit"], document["definitions"]) == ("m", "Mine")
    picked, left, right = document["landmarks"]
    atlas = read_atlas(bare)
    position = atlas.position(atlas.landmarks["front waist point"])
    assert [picked["x"], picked["y"], picked["z"]] == position.tolist()
    assert (picked["origin"], left["origin"]) == ("picked", "rule")
    assert left["x"] == pytest.approx(-right["x"], abs=1e-14)
    assert document["missing"][0]["name"] == "chin point"
    assert document["lacking"] == [
        {"key": "face", "name": "Face", "landmarks": ["chin point", "top of head"]}
    ]
    ran = run("landmarks", bare, "--set", mine, "--format", "csv", "--unit", "m")
    rows = list(csv.DictReader(io.StringIO(ran.out)))
    assert [row["name"] for row in rows] == [
        "front waist point", "waist point left", "waist point right", "chin point",
    ]  # fmt: skip
    assert float(rows[1]["x"]) == left["x"]
    assert rows[3]["patch"] == ""
    assert rows[3]["missing"].startswith("it needs 'top of head'")


def test_an_atlas_without_landmarks_is_listed_too(run: Run, mine: Path) -> None:
    ran = run("landmarks", "enneper", "--set", mine)
    assert (ran.code, ran.err) == (0, "")
    assert "The atlas has no landmark; `bodymeasure landmarks add` adds one." in ran.out
    assert "waist point left: it needs 'front waist point', which the atlas lacks" in ran.out


def test_a_position_is_added(run: Run, tmp_path: Path) -> None:
    new = tmp_path / "new.atlas"
    ran = run(
        "landmarks", "add", "female_average", "bust pont left", "--at", *BUST, "--unit", "cm",
        "-o", new,
    )  # fmt: skip
    note = "'bust pont left' is no name that measurements use; did you mean 'bust point left'?\n"
    assert (ran.code, ran.err) == (0, note)
    assert ran.out == (
        "bust pont left: torso front left bust, u = 0.009345, v = 0.634832, 0.056 cm from the "
        f"position\n{new}: 22 landmarks\n"
    )
    atlas = read_atlas(new)
    found = atlas.position(atlas.landmarks["bust pont left"])
    assert np.linalg.norm(found - np.array(BUST, float) / 100.0) == pytest.approx(5.6e-4, rel=0.01)
    before = load_sample("female_average")
    assert np.array_equal(atlas.points, before.points)
    assert {**atlas.landmarks, **before.landmarks} == atlas.landmarks


def test_a_position_in_a_wrong_unit_is_refused_with_the_right_one(run: Run, bare: Path) -> None:
    before = bare.read_bytes()
    place = ("landmarks", "add", bare, "bust point left", "--in-place", "--at")
    ran = run(*place, *BUST, "--unit", "mm")
    assert (ran.code, ran.out) == (2, "")
    assert "from the surface, more than 20 mm; in cm it would be 0.056 cm from it: check" in ran.err
    assert bare.read_bytes() == before
    ran = run(*place, "9.1", "-30", "116.4", "--unit", "cm")
    assert ran.code == 2
    assert "cm from the surface, more than 2 cm; check its coordinates, its unit" in ran.err
    assert run(*place, "9.1", "-30", "116.4", "--unit", "cm", "--far").code == 0
    assert set(read_atlas(bare).landmarks) == {"front waist point", "bust point left"}


def test_landmarks_are_moved_only_when_told(run: Run, bare: Path) -> None:
    atlas = read_atlas(bare)
    patch = atlas.patch_names[5]
    place = ("landmarks", "add", bare, "front waist point", "--patch", patch, "--uv", "0.25", "1")
    ran = run(*place, "--in-place")
    assert ran.code == 2
    assert "a landmark 'front waist point' already; give --replace to move it" in ran.err
    ran = run(*place, "--in-place", "--replace")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.endswith(f"{bare}: 1 landmark\n")
    assert read_atlas(bare).landmarks == {"front waist point": AtlasPoint(5, 0.25, 1.0)}


def test_vertices_are_counted_from_0_or_from_1(run: Run, bare: Path, tmp_path: Path) -> None:
    body = read_atlas(bare)
    places = [AtlasPoint(10, 0.2, 0.3), AtlasPoint(200, 0.5, 0.5), AtlasPoint(300, 0.9, 0.1)]
    positions = np.array([body.position(place) for place in places]) / Unit.INCH.metres
    mesh = tmp_path / "body.obj"
    lines = ["# a mesh", *(f"v {x!r} {y!r} {z!r} 1" for x, y, z in positions.tolist())]
    mesh.write_text("\n".join([*lines, "vt 0 0", "vn 1 0 0", "f 1/1/1 2/1/1 3/1/1"]), "utf-8")
    name = "elbow point left"
    for options, place in ((("1",), places[1]), (("3", "--from-one"), places[2])):
        ran = run(
            "landmarks", "add", bare, name, "--mesh", mesh, "--unit", "inch", "--in-place",
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
            "landmarks", "add", bare, "x", "--mesh", mesh, "--unit", "inch", "--in-place",
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
        "--unit", "m", "--in-place",
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
        "landmarks", "add", bare, "x", "--mesh", mesh, "--vertex", "0", "--unit", "m", "--in-place"
    )  # fmt: skip
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err


@pytest.mark.parametrize("header", ["", "\ufeffName, x, y, z\n"])
def test_several_are_added_from_a_file(run: Run, bare: Path, tmp_path: Path, header: str) -> None:
    picks = tmp_path / "picks.csv"
    rows = f'{header}bust point left,{",".join(BUST)}\n\n"bust point right",-9.1,-16,1.164e2\n'
    picks.write_text(rows, "utf-8")
    new = tmp_path / "new.atlas"
    ran = run("landmarks", "add", bare, "--from", picks, "--unit", "cm", "-o", new)
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
    ran = run("landmarks", "add", bare, "--from", picks, "--unit", "cm", "--in-place")
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert bare.read_bytes() == before


AT = ("--at", *BUST)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("x", "--in-place"), "one way of --at, --patch, --mesh and --from; got none"),
        (("x", *AT, "--patch", "p", "--in-place"), "got --at and --patch"),
        (
            ("x", *AT, "--in-place"),
            "--at needs --unit, the unit of the position: m, cm, mm or inch",
        ),
        (("x", *AT, "--unit", "cm"), "Give either -o FILE or --in-place"),
        (("x", *AT, "--unit", "cm", "--in-place", "-o", "y.atlas"), "Give either -o FILE or"),
        ((*AT, "--unit", "cm", "--in-place"), "Missing argument 'NAME': what the landmark is"),
        (("x", "--patch", "p", "--in-place"), "--patch and --uv belong together; give both"),
        (("x", *AT, "--uv", "0", "1", "--unit", "cm", "--in-place"), "--patch and --uv belong"),
        (("x", "--mesh", "m.obj", "--unit", "cm", "--in-place"), "--mesh and --vertex belong"),
        (("x", *AT, "--unit", "cm", "--from-one", "--in-place"), "--from-one says how --vertex"),
        (
            ("x", "--patch", "p", "--uv", "0", "1", "--unit", "cm", "--in-place"),
            "--unit is for positions; --patch has none",
        ),
        (
            ("x", "--from", "picks.csv", "--unit", "cm", "--in-place"),
            "--from takes the names from its file; leave NAME out",
        ),
    ],
)
def test_wrong_usage_is_told(
    run: Run, bare: Path, arguments: tuple[str, ...], message: str
) -> None:
    ran = run("landmarks", "add", bare, *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in words(ran.err)
    assert "Try 'bodymeasure landmarks add" in ran.err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--patch", "sleeve", "--uv", "0", "1"), "the atlas has no patch named 'sleeve'"),
        (("--patch", "hip back left 1-1", "--uv", "0", "1.5"), "expected both in [0, 1]"),
        (("--patch", "hip back left 1-1", "--uv", "nan", "1"), "expected both in [0, 1]"),
    ],
)
def test_bad_places_are_told(
    run: Run, bare: Path, arguments: tuple[str, ...], message: str
) -> None:
    ran = run("landmarks", "add", bare, "x", *arguments, "--in-place")
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err


def test_samples_stay_as_they_are(run: Run, tmp_path: Path) -> None:
    for arguments in (
        ("add", "female_average", "x", *AT, "--unit", "cm"),
        ("remove", "female_average", "crotch point"),
    ):
        ran = run("landmarks", *arguments, "--in-place")
        assert (ran.code, ran.out) == (2, "")
        assert "is a sample, which stays as it is; write to a file with -o FILE" in ran.err
    ran = run("landmarks", "remove", "enneper", "x", "-o", tmp_path / "gone" / "a.atlas")
    assert "the atlas has no landmark 'x'; there is none" in ran.err


def test_nothing_is_left_where_nothing_can_be_written(run: Run, tmp_path: Path) -> None:
    target = tmp_path / "gone" / "a.atlas"
    ran = run("landmarks", "remove", "female_average", "crotch point", "-o", target)
    assert (ran.code, ran.out) == (2, "")
    assert "cannot be written" in ran.err
    for name, said in (("a.obj", "a.obj: .obj files hold no landmarks"), ("a", "a: such files")):
        ran = run("landmarks", "remove", "female_average", "crotch point", "-o", tmp_path / name)
        assert (ran.code, ran.out) == (2, "")
        assert said in ran.err
        assert "write to one of .atlas, .npz with -o FILE" in ran.err
    assert list(tmp_path.iterdir()) == []


def test_landmarks_are_removed(run: Run, tmp_path: Path) -> None:
    new = tmp_path / "new.atlas"
    ran = run("landmarks", "remove", "female_old", "crotch point", "elbow point left", "-o", new)
    assert (ran.code, ran.err, ran.out) == (0, "", f"{new}: 19 landmarks\n")
    gone = set(load_sample("female_old").landmarks) - set(read_atlas(new).landmarks)
    assert gone == {"crotch point", "elbow point left"}
    ran = run("landmarks", "remove", new, "crotch pont", "--in-place")
    assert (ran.code, ran.out) == (2, "")
    ran = run("landmarks", "remove", new, "bust pont left", "--in-place")
    assert "no landmark 'bust pont left'; did you mean 'bust point left'?" in ran.err


def test_a_symmetric_body_passes_the_check(run: Run) -> None:
    ran = run("landmarks", "check", "male_average")
    assert (ran.code, ran.err) == (0, "")
    assert "Mirror: the plane in which the surface is most nearly symmetric" in ran.out
    assert "with normal (1.0000, 0.0000, 0.0000)" in ran.out
    assert "0 remarks; landmarks that are off by more than 0.50 cm get one\n" in ran.out
    across = run("landmarks", "check", "male_average", "--mirror", "axes", "--unit", "mm")
    assert "Mirror: the plane across the atlas's axes through its median landmarks" in across.out
    assert "more than 5.0 mm" in across.out


def test_the_check_tells_what_is_off(run: Run, tmp_path: Path) -> None:
    body = load_sample("female_average")
    landmarks = {
        **body.landmarks,
        "bust point left": AtlasPoint(215, 0.6, 0.3),
        "front hip point": AtlasPoint(109, 0.1, 0.6),
        "acromion left": AtlasPoint(208, 0.5, 0.5),
    }
    file = tmp_path / "off.atlas"
    write_atlas(replace(body, landmarks=landmarks), file)
    ran = run("landmarks", "check", file)
    assert (ran.code, ran.err) == (1, "")
    for said in (
        "not the mirror image of bust point right",
        "off the mirror, to the right",
        "has no partner acromion right",
        "unknown; did you mean 'shoulder point left'?",
        "4 remarks;",
    ):
        assert said in ran.out
    ran = run("landmarks", "check", file, "--within", "30", "--format", "json")
    assert ran.code == 1
    document = json.loads(ran.out)
    assert (document["mirror"], document["within"], document["unit"]) == ("fitted", 30.0, "cm")
    remarks = [record for record in document["landmarks"] if record["remark"]]
    assert [record["checked"] for record in remarks] == ["partner", "name"]
    rows = list(csv.DictReader(io.StringIO(run("landmarks", "check", file, "--format", "csv").out)))
    assert (rows[0]["name"], rows[0]["checked"]) == ("bust point left", "pair")
    mirrored = body.position(landmarks["bust point left"]) * [-1.0, 1.0, 1.0]
    apart = 100.0 * np.linalg.norm(mirrored - body.position(landmarks["bust point right"]))
    assert float(rows[0]["distance"]) == pytest.approx(apart, rel=1e-12)


@pytest.mark.parametrize("command", ["list", "add", "remove", "check"])
def test_each_subcommand_has_help(run: Run, command: str) -> None:
    ran = run("landmarks", command, "--help")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(f"Usage: bodymeasure landmarks {command} [OPTIONS] ATLAS")
    assert "Exit codes: 0 done; 1 done, but" in words(ran.out)


def test_no_atlas_is_a_usage_error(run: Run) -> None:
    ran = run("landmarks")
    assert (ran.code, ran.out) == (2, "")
    assert "Missing argument 'ATLAS'" in ran.err
    ran = run("landmarks", "gone.atlas")
    assert (ran.code, ran.out) == (2, "")
    assert "gone.atlas: no such file" in ran.err
    ran = run("landmarks", "--help")
    assert ran.code == 0
    assert ran.out.startswith("Usage: bodymeasure landmarks [OPTIONS] [COMMAND] ATLAS [ARGS]...")
