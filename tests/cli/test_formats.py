import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from helpers.command_line import Run
from helpers.speed import quick
from helpers.surfaces.solids import CUBE, icosphere, obj_text

from bodymeasure import Axes, InputError, load_sample, read_atlas, write_atlas

DATA = Path(__file__).parents[1] / "data"
MESH = """v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0.5
g left
f 1 2 5 4
g right
f 2 3 6 5
"""


@pytest.fixture
def teapot(tmp_path: Path) -> Path:
    return Path(shutil.copy(DATA / "teapot.bpt", tmp_path))


def test_loose_patches_are_converted_to_an_atlas(run: Run, teapot: Path) -> None:
    target = teapot.with_suffix(".atlas")
    ran = run("convert", teapot, "-o", target, "--file-unit", "inch", "--up", "+z", "--front", "-x")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == f"{target}: 32 patches, 52 seams, 4 parts, in inch\n"
    atlas = read_atlas(target)
    assert (atlas.unit, atlas.axes.front) == ("inch", "-x")
    assert atlas.digest == read_atlas(teapot, unit="inch").digest


def test_what_is_lost_is_told(run: Run, tmp_path: Path) -> None:
    target = tmp_path / "body.obj"
    ran = run("convert", "female_average", "-o", target)
    assert ran.code == 0
    sample = load_sample("female_average")
    assert ran.err == (
        "a Wavefront OBJ file cannot hold its unit (m) and axes, "
        f"{len(sample.given)} given lengths, {len(sample.landmarks)} landmarks; "
        "the file lacks these.\n"
    )
    back = read_atlas(target, unit="m")
    assert back.digest == sample.digest
    assert back.patch_names == sample.patch_names


def test_a_group_of_a_mesh(run: Run, tmp_path: Path) -> None:
    (tmp_path / "mesh.obj").write_text(MESH)
    target = tmp_path / "left.atlas"
    arguments = ("convert", tmp_path / "mesh.obj", "-o", target, "--file-unit", "cm", "--group")
    ran = run(*arguments, "left")
    assert (ran.code, ran.err) == (0, "")
    first, *sentences = ran.out.splitlines()
    assert first == f"{target}: 1 patch, 0 seams, 1 part, in cm"
    assert sentences[0] == "The patches are the Catmull-Clark surface of a mesh."
    ran = run(*arguments, "middle")
    assert (ran.code, ran.out) == (2, "")
    assert "no patch is in a group 'middle'; there are: left, right" in ran.err


def test_formats_may_be_told(run: Run, teapot: Path) -> None:
    renamed = teapot.rename(teapot.with_name("teapot.txt"))
    target = teapot.with_name("other.txt")
    options = ("--from", "bpt", "--format", "bez", "--file-unit", "cm", "--weld", "0.001")
    ran = run("convert", renamed, "-o", target, *options)
    assert ran.code == 0
    assert target.read_bytes().startswith(b"BBP\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("convert", "teapot.bpt"), "Missing option '-o'"),
        (("convert", "teapot.bpt", "-o", "x.atlas"), "a BPT file says no unit, and none was given"),
        (("convert", "teapot.bpt", "-o", "x.stl"), "unknown kind of file '.stl'"),
        (("convert", "teapot.bpt", "-o", "no/x.atlas"), "no/x.atlas: cannot be written"),
        (
            ("convert", "teapot.bpt", "-o", "x.obj", "--file-unit", "ft"),
            "'ft' is not one of 'm', 'cm'",
        ),
        (
            ("convert", "enneper", "-o", "x.obj", "--file-unit", "m"),
            "is in cm, but the unit m was given",
        ),
        (("convert", "enneper", "-o", "x.obj", "--format", "obj-mesh"), "'obj-mesh' is not one of"),
        (("info", "teapot.bpt"), "says no unit"),
        (("check", "teapot.bpt"), "--file-unit on the command line"),
        (("diagonals", "teapot.bpt", "--unit", "cm"), "says no unit, and none was given"),
    ],
)
def test_bad_input_is_told_and_nothing_written(
    run: Run,
    teapot: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    monkeypatch.chdir(teapot.parent)
    ran = run(*arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert [path.name for path in teapot.parent.iterdir()] == ["teapot.bpt"]


def test_info_says_what_an_atlas_holds(run: Run, teapot: Path) -> None:
    ran = run("info", teapot, "--file-unit", "cm")
    assert (ran.code, ran.err) == (0, "")
    title, *rows = ran.out.splitlines()
    assert title == str(teapot)
    table = {row[:17].strip(): row[17:].strip() for row in rows}
    assert table["patches"] == "32, 302 control points"
    assert table["degree"] == "3, polynomial"
    assert table["size"] == "3.15 high, 6.434 wide, 4 deep cm"
    assert table["seams"] == "52; 16 edges on the boundary, 8 collapsed to a point"
    assert table["parts"] == "4"
    assert table["landmarks"] == "none"
    assert table["quality"].startswith("0 errors, 9 warnings: collapsed edge (8), separate parts")


def test_info_lists_landmarks_and_where_an_atlas_comes_from(run: Run) -> None:
    ran = run("info", "female_average")
    assert (ran.code, ran.err) == (0, "")
    sample = load_sample("female_average")
    count = len(sample.landmarks)
    (listed,) = (line for line in ran.out.splitlines() if line.startswith("landmarks"))
    assert f" {count}: {next(iter(sample.landmarks))}, " in listed
    assert listed.endswith(f" and {count - 8} more")
    for key, value in sample.provenance.items():
        assert any(row.startswith(key) and row.endswith(value) for row in ran.out.splitlines())


def test_info_of_a_rational_surface(run: Run) -> None:
    ran = run("info", DATA / "octant.bez", "--file-unit", "m")
    assert "3, rational" in ran.out


def test_the_unit_of_a_file_has_one_name(run: Run, teapot: Path) -> None:
    ran = run("check", teapot, "--file-unit", "mm")
    assert ran.code == 0
    assert ran.out.endswith("32 patches in mm, 0 errors, 9 warnings\n")
    for command in ("check", "info", "view"):
        ran = run(command, teapot, "--unit", "mm")
        assert (ran.code, ran.out) == (2, "")
        assert "Did you mean" in ran.err
        assert "--file-unit" in ran.err


def test_convert_reads_one_unit_and_writes_another(run: Run, teapot: Path) -> None:
    target = teapot.parent / "teapot.atlas"
    ran = run("convert", teapot, "-o", target, "--unit", "mm")
    assert (ran.code, target.exists()) == (2, False)
    assert "--file-unit on the command line" in ran.err
    ran = run("convert", teapot, "-o", target, "--file-unit", "cm", "--unit", "mm")
    assert ran.code == 0
    written, read = read_atlas(target), read_atlas(teapot, unit="cm")
    assert written.unit == "mm"
    assert written.points == pytest.approx(10.0 * read.points, rel=1e-15)


@pytest.mark.parametrize("command", quick(["info", "check", "diagonals"], first=2))
def test_all_that_read_an_atlas_take_its_axes(run: Run, teapot: Path, command: str) -> None:
    options = ("--file-unit", "cm", "--up", "+y", "--front", "+z")
    ran = run(command, teapot, *options)
    assert ran.code == 0
    if command == "info":
        assert "up +y, front +z" in ran.out
    refused = run(command, "enneper", "--up", "+y", "--front", "+z")
    assert (refused.code, refused.out) == (2, "")
    assert "has up +z and front -y, but others were given" in refused.err


def test_lengths_have_a_unit_of_their_own(run: Run, teapot: Path) -> None:
    options = ("--format", "csv", "--unit", "mm", "--despite-errors")
    ran = run("diagonals", teapot, "--file-unit", "cm", *options)
    assert (ran.code, ran.err) == (0, "")
    first = ran.out.splitlines()[1].split(",")
    assert "mm" in first
    assert any(word.startswith("22.2795") for word in first)


def test_the_unit_of_one_file_is_not_that_of_the_next(run: Run, teapot: Path) -> None:
    assert run("check", teapot, "--file-unit", "mm").code == 0
    assert run("check", teapot).code == 2


def test_what_an_approximation_costs_is_said_and_kept(run: Run, tmp_path: Path) -> None:
    mesh, target = tmp_path / "cube.obj", tmp_path / "cube.atlas"
    mesh.write_text(obj_text(CUBE, size=10.0))
    options = ("--file-unit", "cm", "-o", target)
    ran = run("convert", mesh, *options, "--deviation", "inf", "--unit", "mm")
    sentences = ran.out.splitlines()[1:]
    assert sentences == [
        "The patches approximate the Catmull-Clark surface of a mesh: they lie within 0.086 cm of "
        "it (root mean square 0.086 cm), and lengths differ by at most 3 % there, 3 % on "
        "average.",
        "The mesh itself lies within 4.3 cm of the patches (root mean square 3 cm); lengths on it "
        "are about 62 % longer.",
    ]
    assert (
        ran.err == "--interpolate lets the surface run through the vertices of the mesh instead.\n"
    )
    through = run("convert", mesh, *options, "--interpolate")
    assert "approximate a Catmull-Clark surface through the vertices of a mesh" in through.out
    assert through.err == ""
    ran = run("convert", mesh, *options, "--deviation", "inf", "--unit", "mm")
    described = " ".join(run("info", target).out.split())
    assert "approximation The patches approximate" in described
    assert "they lie within 0.86 mm of it" in described
    # The mesh is no longer there to be interpolated.
    assert run("convert", target, "-o", tmp_path / "again.atlas", "--unit", "m").err == ""
    ran = run("convert", mesh, *options, "--deviation", "0.01")
    assert ran.out.startswith(f"{target}: 24 patches,")
    ran = run("convert", mesh, "--file-unit", "cm", "-o", tmp_path / "cube.bpt")
    assert "how well its patches approximate their surface; the file lacks these" in ran.err
    assert "the parameters of the faces of its file" in ran.err


@pytest.mark.parametrize("command", ["convert", "check", "info", "diagonals", "report"])
def test_a_mesh_of_triangles_needs_to_be_asked_for(run: Run, tmp_path: Path, command: str) -> None:
    mesh, target = tmp_path / "ball.obj", tmp_path / "out"
    mesh.write_text(obj_text(icosphere(1)))
    output = {"convert": ("-o", f"{target}.atlas"), "report": ("-o", target)}.get(command, ())
    ran = run(command, mesh, "--file-unit", "cm", *output)
    assert ran.code == 2
    assert "ball.obj: is a mesh of 80 triangles, and would become 240 patches" in ran.err
    assert f"`bodymeasure fit {mesh} --file-unit cm`" in ran.err
    assert list(tmp_path.iterdir()) == [mesh]
    scan = tmp_path / "scan.stl"
    scan.write_bytes(b"solid")
    ran = run(command, scan, "--file-unit", "mm", *output)
    assert ran.code == 2
    assert f"`bodymeasure chart {scan} --file-unit UNIT`" in ran.err


def test_a_mesh_of_triangles_becomes_patches_if_asked_for(run: Run, tmp_path: Path) -> None:
    mesh, target = tmp_path / "ball.obj", tmp_path / "ball.atlas"
    mesh.write_text(obj_text(icosphere(1)))
    ran = run("convert", mesh, "--file-unit", "cm", "--quads", "--deviation", "inf", "-o", target)
    assert ran.out.startswith(f"{target}: 240 patches,")
    assert run("info", target, "--quads").err.startswith("Error")


def test_wrong_axes_of_an_atlas_are_corrected(run: Run, tmp_path: Path) -> None:
    body = load_sample("female_average")
    lying = body.turned(Axes("+y", "+z"))
    wrong = tmp_path / "wrong.atlas"
    write_atlas(replace(lying, axes=Axes()), wrong)
    assert run("check", wrong).code == 1
    # What is measured must not be corrected unseen.
    refused = run("info", wrong, "--up", "+y", "--front", "+z").err
    assert "has up +z and front -y, but others were given" in refused
    assert "`bodymeasure convert`" in refused
    right = tmp_path / "right.atlas"
    ran = run("convert", wrong, "--up", "+y", "--front", "+z", "-o", right)
    assert (ran.code, ran.err) == (0, "")
    corrected = read_atlas(right)
    assert corrected.axes == Axes("+y", "+z")
    assert (corrected.points == lying.points).all()
    # One of the two alone would lie along the other one.
    ran = run("convert", wrong, "--up", "+y", "-o", tmp_path / "half.atlas")
    assert ran.code == 2
    assert "lie along the same axis" in ran.err

    ran = run("convert", wrong, "--up", "+y", "--front", "+z", "--upright", "-o", right)
    assert ran.code == 0
    turned = read_atlas(right)
    assert turned.axes == Axes()
    assert turned.points == pytest.approx(body.points, abs=1e-15)
    assert run("check", right).code == 0


@pytest.mark.parametrize("axes", [("+x", "-z"), ("-y", "+x"), ("+z", "+y")])
def test_turning_a_body_turns_it_whole(axes: tuple[str, str]) -> None:
    body = load_sample("female_average")
    turned = body.turned(Axes(*axes))
    for name in ("up_vector", "front_vector", "left_vector"):
        before = body.points @ getattr(body.axes, name)
        assert turned.points @ getattr(turned.axes, name) == pytest.approx(before, abs=1e-15)


def test_swapped_arguments_are_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="expected an Atlas"):
        write_atlas(tmp_path / "a.atlas", load_sample("paraboloid"))  # type: ignore[arg-type]


def test_only_formats_that_can_be_written_are_offered(run: Run, tmp_path: Path) -> None:
    for name in ("x.stl", "x.3dm"):
        ran = run("convert", "paraboloid", "-o", tmp_path / name)
        assert ran.code == 2
        assert ".obj" in ran.err
        assert ".step" not in ran.err


def test_a_mesh_is_not_overwritten_with_its_patches(run: Run, tmp_path: Path) -> None:
    mesh = tmp_path / "mesh.obj"
    mesh.write_text(MESH, encoding="ascii")
    ran = run("convert", mesh, "-o", mesh)
    assert (ran.code, ran.out) == (2, "")
    assert "is the file to convert, which would be lost; give another one" in ran.err
    assert mesh.read_text(encoding="ascii") == MESH
