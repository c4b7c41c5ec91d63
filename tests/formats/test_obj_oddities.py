"""Wavefront OBJ files as exporters and editors leave them."""

import codecs

import numpy as np
import pytest
from helpers.files.format_atlases import body_like, read, write

from bodymeasure import InputError
from bodymeasure.errors import ReadWarning

SQUARE = "v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3 4\n"
DIGEST = read(SQUARE.encode(), "obj").digest
SURFACES = write(body_like(1, 2), "obj").decode()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "v 0 0 0",
            "# made\nExported from a tool\nv 0 0 0",
            r"line 2 \('Exported'\) is no statement",
        ),
        ("v 0 0 0", "3D Tool 2.1\n==== 8 ====\nv 0 0 0", r"line 1 \('3D'\), line 2 .* are no"),
        ("f 1", "-- faces --\nf 1", r"line 5 \('--'\) is no statement"),
        ("3 4\n", "3 4\n\x1a", r"line 6 \('\\x1a'\) is no statement"),
        ("v 0 0 0", "a\n" * 9 + "v 0 0 0", r"line 4 \('a'\) and 5 more are no statements"),
    ],
)
def test_lines_of_prose_are_left_out_and_told(old: str, new: str, message: str) -> None:
    with pytest.warns(ReadWarning, match=rf"^file: .*{message}.* left out"):
        atlas = read(SQUARE.replace(old, new, 1).encode(), "obj")
    assert atlas.digest == DIGEST


@pytest.mark.parametrize("line", ["vv 0 0 0", "V 0 0 0", "v0 0 0", "0 0 0", "fcae 1 2 3", "v3"])
def test_what_may_be_a_misspelled_vertex_or_face_is_refused(line: str) -> None:
    with pytest.raises(InputError, match=r"^file, line 2: begins with .* which is no statement"):
        read(SQUARE.replace("v 3 0 0", f"{line}\nv 3 0 0").encode(), "obj")


def test_the_state_of_free_form_surfaces_is_never_left_out() -> None:
    with pytest.warns(ReadWarning, match=r"line 1 \('Exported'\)"):
        atlas = read(f"Exported by hand\n{SURFACES}".encode(), "obj")
    assert atlas.digest == body_like(1, 2).digest
    with pytest.raises(InputError, match=r"^file, line 32: begins with 'dge'"):
        read(SURFACES.replace("deg 3 3", "deg 3 3\ndge 2").encode(), "obj")


@pytest.mark.parametrize("color", ["nan nan nan", "inf 1 -1", "red green blue"])
def test_colors_of_vertices_need_not_be_numbers(color: str) -> None:
    plain = SQUARE.replace("v 3 0 0", f"v 3 0 0 {color}").replace("v 0 4 0", "v 0 4 0 1 1 1")
    assert read(plain.encode(), "obj").digest == DIGEST
    weighted = SURFACES.replace("v 0.0 0.0 0.0", f"v 0.0 0.0 0.0 2.0 {color}")
    weighted = weighted.replace("cstype", "cstype rat")
    weights = read(weighted.encode(), "obj").weights
    assert weights is not None
    assert (weights.max(), weights.min()) == (2.0, 1.0)
    with pytest.raises(InputError, match=r"^file, line 3: 'nan' is not a finite number"):
        read(plain.replace("v 3 4 0", "v 3 nan 0").encode(), "obj")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_byte_order_mark_tells_the_encoding(encoding: str, end: str) -> None:
    text = SQUARE.replace("f 1", "g Ärmel 袖\nf 1").replace("\n", end)
    assert read(f"\ufeff{text}".encode(encoding), "obj").regions == ("Ärmel 袖",)
    bpt = write(body_like(1, 1), "bpt").decode()
    assert read(f"\ufeff{bpt}".encode(encoding), "bpt").digest == body_like(1, 1).digest


def test_text_that_breaks_its_encoding_is_refused() -> None:
    content = codecs.BOM_UTF16_LE + SQUARE.encode("utf-16-le")[:-1]
    with pytest.raises(InputError, match=r"^file: begins as text in UTF-16-LE, but byte \d+ is no"):
        read(content, "obj")


def test_names_in_other_encodings_are_read_as_latin_1() -> None:
    text = SQUARE.replace("f 1", "o Körper\ng Ärmel\nf 1")
    atlas = read(text.encode("latin-1"), "obj")
    assert (atlas.patch_names, atlas.regions) == (("Körper face 1",), ("Ärmel",))
    mixed = text.encode().replace("Ä".encode(), b"\xc4")
    assert read(mixed, "obj").patch_names == ("Körper face 1",)


def test_a_name_may_hold_the_sign_of_comments() -> None:
    text = SQUARE.replace("f 1", "o body #2\ng panel #1 left\nf 1").replace(
        "3 4\n", "3 4 # f 9 9\n"
    )
    atlas = read(text.encode(), "obj")
    assert (atlas.patch_names, atlas.regions) == (("body #2 face 1",), ("panel #1 left",))


@pytest.mark.parametrize(
    "faces", ["f -4 -3 -2 -1\n", "f 1 2 3\n", "cstype bezier\ndeg 1\nsurf 0 1 0 1 1 2 3 4\nend\n"]
)
def test_a_file_without_vertices_says_so(faces: str) -> None:
    with pytest.raises(InputError, match=r"refers to vertex '.*', but the file holds no vertex"):
        read(faces.encode(), "obj")
    with pytest.raises(InputError, match=r"line 1: refers to vertex '-1'; expected 1 to 4$"):
        read(f"f -1 2 3\n{SQUARE}".encode(), "obj")


@pytest.mark.parametrize("ranges", ["0 0.333333 0 1.0000004", "-3e-8 0.33333334 2e-9 1"])
def test_ends_of_a_range_that_rounding_moves_are_the_knots(ranges: str) -> None:
    bezier = SURFACES.replace("parm u 0 1", "parm u 0 0.3333333333333333")
    exact = read(bezier.replace("surf 0 1 0 1", "surf 0 0.3333333333333333 0 1").encode(), "obj")
    rounded = read(bezier.replace("surf 0 1 0 1", f"surf {ranges}").encode(), "obj")
    assert len(rounded) == 2
    np.testing.assert_array_equal(rounded.control_points, exact.control_points)
