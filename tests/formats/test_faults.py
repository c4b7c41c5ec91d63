"""A fault in a file is reported with its line."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.files.format_atlases import TEXT, body_like, read, write

from bodymeasure import InputError, read_atlas
from bodymeasure.errors import ReadWarning

BPT = write(body_like(1, 2), "bpt").decode().splitlines()
BEZ = write(body_like(1, 2), "bez").decode().splitlines()
Edit = Callable[[list[str]], object]


def put(line: int, text: str) -> Edit:
    """Replace a line, counted from 1."""
    return lambda lines: lines.__setitem__(line - 1, text)


@pytest.mark.parametrize("form", TEXT)
@pytest.mark.parametrize(
    ("content", "message"),
    [(b"", "file"), (b" \n# nothing\n", "file"), (b"\x00\x01\x02", "file"), (b"\xff\xfe", "file")],
)
def test_what_is_no_such_file_is_refused(form: str, content: bytes, message: str) -> None:
    with pytest.raises(InputError, match=f"^{message}"):
        read(content, form)


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (
            put(1, "1000000000"),
            r"line 1: says 1000000000 patches; expected .* more than the 6 that",
        ),
        (put(1, "0"), "line 1: says 0 patches"),
        (put(1, "-1"), "line 1: says -1 patches"),
        (put(1, "2 2"), "line 1: has 2 words; expected the number of patches alone"),
        (put(1, "two"), "line 1: 'two' is not a whole number; expected the number of patches"),
        (put(1, "1_0"), "line 1: '1_0' is not a whole number"),
        (put(1, "1"), "line 19: goes on after the last of 1 patches"),
        (put(1, "3"), "ends within patch 2; the file may have been cut off"),
        (put(2, "3"), "line 2: has 1 words; expected the two degrees of patch 0, such as 3 3"),
        (put(2, "0 3"), "line 2: degrees 0 and 3; expected"),
        (put(2, "3 4"), "line 19: has 2 words; expected x, y and z of a control point of patch 0"),
        (put(2, "1000000000 1000000000"), "line 19: has 2 words"),
        (put(5, "1 2"), "line 5: has 2 words; expected x, y and z"),
        (put(5, "1 2 nan"), "line 5: 'nan' is not a finite number; expected numbers such as"),
        (put(5, "1 2 -inf"), "line 5: '-inf' is not a finite number"),
        (put(5, "1 2 1e999"), "line 5: '1e999' is not a finite number"),
        (put(5, "1 2 0x1p3"), "line 5: '0x1p3' is not a finite number"),
        (put(5, "1 2 1_000"), "line 5: '1_000' is not a finite number"),
        (put(5, "1 2 1,5"), "line 5: '1,5' is not a finite number"),
        (put(5, "1 2 " + "9" * 50 + "x"), r"line 5: '9{24}\.\.\.' is not a finite number"),
        (put(5, "1 2 1e70"), r"the atlas extends over 1e\+70; expected a size between"),
        (lambda lines: lines.pop(), "ends within patch 1"),
        (lambda lines: lines.insert(6, "# remark\n\n\n x"), "line 10: has 1 words"),
    ],
)
def test_faults_of_a_bpt_file(edit: Edit, message: str) -> None:
    lines = list(BPT)
    edit(lines)
    with pytest.raises(InputError, match=f"^file(, |: ){message}"):
        read("\n".join(lines).encode(), "bpt")


def test_remarks_blank_lines_and_ends_of_lines_of_all_systems_are_passed_over() -> None:
    expected = read("\n".join(BPT).encode(), "bpt").digest
    for end in ("\n", "\r\n", "\r"):
        body = (" # remark" + end + end + "\t").join(BPT)
        for content in (f"# first{end}{body}", f"\ufeff{end}{body}", f"{body}{end}{end}#"):
            assert read(content.encode(), "bpt").digest == expected


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (put(1, "BBQ"), "line 1: begins with 'BBQ'; expected BBP or BEZ with two degrees"),
        (put(1, "BEZ737"), "line 1: begins with 'BEZ737'"),
        (put(1, "{ BBP"), "line 1: begins with '{'; expected BBP .* without braces"),
        (put(1, "BINARY BBP"), "begins with 'BINARY'"),
        (put(1, "BEZ433"), r"line 34: the file ends after 96 numbers; expected a multiple of 60"),
        (put(3, "1 2"), "line 34: the file ends after 95 numbers; expected a multiple of 48"),
        (put(3, "1 2 3 4 five"), "line 3: 'five' is not a finite number"),
        (lambda lines: lines.__delitem__(slice(1, None)), "line 1: the file ends after 0 numbers"),
        (
            lambda lines: lines.__setitem__(slice(None), ["BEZ114", *["0 0 1 1"] * 7, "0 1 0 0"]),
            "line 6: patch 1 has weights from 0 to 1; expected positive",
        ),
    ],
)
def test_faults_of_a_geomview_file(edit: Edit, message: str) -> None:
    lines = list(BEZ)
    edit(lines)
    with pytest.raises(InputError, match=f"^file.*{message}"):
        read("\n".join(lines).encode(), "bez")


def test_colors_and_texture_coordinates_are_left_out() -> None:
    atlas = body_like(1, 2)
    head, *lines = BEZ
    assert head == "BBP"
    nets = "\n".join(lines).split("\n\n")
    texture, colors = "0 0 0 1\n1 0 1 1\n", "1 .5 0 1  1 0 0 1\n1 0 0 1  0 0 0 1\n"
    for header, extra in (
        ("STBBP", texture),
        ("BEZ333_ST", texture),
        ("CBEZ333", colors),
        ("CBEZ333_ST", texture + colors),
    ):
        content = header + "\n" + "".join(f"{net}\n{extra}" for net in nets[:2])
        assert read(content.encode(), "bez").digest == atlas.digest


def test_degrees_of_a_geomview_file_are_those_of_u_and_v() -> None:
    # The net has 3 x 2 control points, and u runs fastest.
    content = b"BEZ213 0 0 0  1 0 0  2 0 1   0 1 0  1 1 0  2 1 1"
    (net,) = read(content, "bez").control_points
    np.testing.assert_allclose(
        net[:, 0], np.array([[0, 0, 0], [2 / 3, 0, 0], [4 / 3, 0, 1 / 3], [2, 0, 1]])
    )
    np.testing.assert_allclose(net[3, :, 1], [0, 1 / 3, 2 / 3, 1])


def changed(*path: Any) -> Callable[[dict[str, Any]], None]:
    """Set the member at all but the last of `path` to its last."""

    def change(members: dict[str, Any]) -> None:
        *keys, last, value = path
        target: Any = members
        for key in keys:
            target = target[key]
        target[last] = value

    return change


SURFACE = ("shape", "data", 1)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (changed("shape", "type", "curve"), "has a shape of type 'curve'; expected geomdl's JSON"),
        (changed("shape", None), "has a shape of type None"),
        (changed("shape", "count", 3), "says 3 surfaces, but holds 2"),
        (changed("shape", "data", []), "says 2 surfaces, but holds 0"),
        (changed(*SURFACE, "degree_u", 2), r"surface 1 \('patch 1'\): in u: 8 knots .*expected 7"),
        (changed(*SURFACE, "degree_v", "3"), "Expected `int`, got `str`"),
        (changed(*SURFACE, "size_v", 10**9), "has 16 control points; expected 4 x 1000000000"),
        (changed(*SURFACE, "size_v", -4), "has 16 control points; expected 4 x -4"),
        (changed(*SURFACE, "knotvector_v", [0, 0, 0, 2, 1, 1, 1, 1]), "in v: knots decrease"),
        (changed(*SURFACE, "dimension", 2), "is a spline of dimension 2; expected a spline of"),
        (changed(*SURFACE, "type", "freeform"), "is a freeform of dimension 3"),
        (changed(*SURFACE, "trims", {"count": 1}), "is trimmed; only whole surfaces can be read"),
        (changed(*SURFACE, "control_points", "points", 3, [1, 2]), r"has points of \[2, 3\] coord"),
        (changed(*SURFACE, "control_points", "points", 3, [1, 2, "x"]), "Expected `float`"),
        (changed(*SURFACE, "rational", True), None),
    ],
)
def test_faults_of_a_geomdl_file(
    change: Callable[[dict[str, Any]], None], message: str | None
) -> None:
    members = json.loads(write(body_like(1, 2), "geomdl"))
    change(members)
    content = json.dumps(members).encode()
    if message is None:
        assert len(read(content, "geomdl")) == 2
        return
    with pytest.raises(InputError, match=f"^file.*{message}"):
        read(content, "geomdl")


@pytest.mark.parametrize(
    ("weights", "message"),
    [
        ([1.0] * 15, "has 15 weights for 16 control points"),
        ([1.0] * 15 + [0.0], r"surface 0.*: patch 0 has weights from 0 to 1; expected positive"),
        ([-1.0] * 16, r"patch 0 has weights from -1 to -1; expected positive"),
    ],
)
def test_weights_must_be_positive(weights: list[float], message: str) -> None:
    members = json.loads(write(body_like(1, 1), "geomdl"))
    members["shape"]["data"][0]["rational"] = True
    members["shape"]["data"][0]["control_points"]["weights"] = weights
    with pytest.raises(InputError, match=message):
        read(json.dumps(members).encode(), "geomdl")


def test_equal_weights_are_none() -> None:
    members = json.loads(write(body_like(1, 1), "geomdl"))
    members["shape"]["data"][0]["rational"] = True
    members["shape"]["data"][0]["control_points"]["weights"] = [0.7] * 16
    atlas = read(json.dumps(members).encode(), "geomdl")
    assert not atlas.is_rational
    assert atlas.digest == body_like(1, 1).digest


def test_json_that_is_none_is_told_with_its_line() -> None:
    content = write(body_like(1, 1), "geomdl")
    with pytest.raises(InputError, match=r"^file, line 1: is not valid JSON"):
        read(content[:200], "geomdl")
    with pytest.raises(InputError, match=r"^file: "):
        read(b'{"shape": ' + b"[" * 100_000, "geomdl")


def test_a_degree_beyond_the_largest_is_refused() -> None:
    side = np.linspace(0.0, 1.0, 11)
    points = "\n".join(f"{x} {y} 0" for y in side for x in side)
    with pytest.raises(InputError, match=r"^file, line 2: patch 0 has the degrees 10 and 10; only"):
        read(f"1\n10 10\n{points}\n".encode(), "bpt")


def test_bpt_patches_of_high_degree_are_left_out_by_name(tmp_path: Path) -> None:
    def patch(degree: int, shift: int) -> str:
        rows = [f"{u + shift} {v} 0" for v in range(degree + 1) for u in range(degree + 1)]
        return "\n".join([f"{degree} {degree}", *rows])

    path = tmp_path / "high.bpt"
    path.write_text("\n".join(["2", patch(10, 0), patch(3, 20)]))
    with pytest.warns(ReadWarning, match=r"line 2: patch 0 has the degrees 10 and 10.*left out"):
        atlas = read_atlas(path, unit="cm")
    assert len(atlas) == 1
    assert atlas.points[:, 0].min() == 20.0
    path.write_text("\n".join(["1", patch(10, 0)]))
    with pytest.raises(InputError, match=r"high.bpt, line 2: patch 0 has the degrees 10 and 10"):
        read_atlas(path, unit="cm")
