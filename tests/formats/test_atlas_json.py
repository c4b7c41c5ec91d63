import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from bodymeasure import Atlas, AtlasPoint, Axes, InputError, Unit
from bodymeasure.formats import atlas_json

VALID = atlas_json.write(
    Atlas(
        grid_atlas(1, 2).points,
        grid_atlas(1, 2).index,
        Unit.CM,
        patch_names=("hip left", "hip right"),
        landmarks={"c7": AtlasPoint(1, 0.25, 0.5)},
        provenance={"author": "nobody"},
    )
)

# All characters but lone surrogates, which UTF-8 cannot encode.
texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
# Patches have names that a table can show.
names = st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=12).filter(str.strip)
coordinates = st.floats(allow_nan=False, allow_infinity=False)
units = st.sampled_from(Unit)
axes = st.sampled_from([Axes("+z", "-y"), Axes("+y", "+z"), Axes("-x", "+y")])


@st.composite
def atlases(draw: st.DrawFn) -> Atlas:
    patches = draw(st.integers(1, 3))
    points = draw(arrays(np.float64, (draw(st.integers(1, 20)), 3), elements=coordinates))
    numbers = st.integers(0, len(points) - 1)
    places = st.builds(
        AtlasPoint, st.integers(0, patches - 1), st.floats(0.0, 1.0), st.floats(0.0, 1.0)
    )
    return Atlas(
        points,
        draw(arrays(np.int64, (patches, 4, 4), elements=numbers)),
        draw(units),
        tuple(draw(st.lists(names, min_size=patches, max_size=patches, unique=True))),
        tuple(draw(st.lists(texts, min_size=patches, max_size=patches))),
        draw(st.dictionaries(texts, places, max_size=3)),
        draw(axes),
        draw(texts),
        draw(st.dictionaries(texts, texts, max_size=3)),
    )


@given(atlases())
def test_an_atlas_survives_a_round_trip_to_the_last_bit(atlas: Atlas) -> None:
    content = atlas_json.write(atlas)
    back = atlas_json.read(content, "body.atlas")
    assert back.points.tobytes() == atlas.points.tobytes()
    np.testing.assert_array_equal(back.index, atlas.index)
    for field in ("unit", "patch_names", "regions", "landmarks", "axes", "name", "provenance"):
        assert getattr(back, field) == getattr(atlas, field), field
    assert back.digest == atlas.digest
    assert atlas_json.write(back) == content


def test_extreme_numbers_survive() -> None:
    extremes = [5e-324, -5e-324, 2.2250738585072014e-308, -0.0, 1.7976931348623157e308, 0.1, 1 / 3]
    points = np.resize(extremes, (16, 3))
    atlas = Atlas(points, np.arange(16).reshape(1, 4, 4), Unit.M)
    assert atlas_json.read(atlas_json.write(atlas), "x").points.tobytes() == points.tobytes()


def test_a_file_is_text_with_a_line_for_each_thing() -> None:
    lines = VALID.decode().splitlines()
    assert '"unit": "cm",' in lines
    assert sum(line.startswith('{"name": "hip') for line in lines) == 2
    assert sum(line.startswith("[") for line in lines) == 28


def test_a_byte_order_mark_is_ignored() -> None:
    assert (
        atlas_json.read(b"\xef\xbb\xbf" + VALID, "x").digest == atlas_json.read(VALID, "x").digest
    )


def test_only_what_has_a_default_may_be_left_out() -> None:
    members = json.loads(VALID)
    for key in ("name", "provenance", "landmarks"):
        del members[key]
    for patch in members["patches"]:
        del patch["region"]
    atlas = atlas_json.read(json.dumps(members).encode(), "x")
    assert (atlas.name, atlas.landmarks, atlas.regions) == ("", {}, ("", ""))


def test_text_that_utf_8_cannot_write_is_refused() -> None:
    atlas = Atlas(np.zeros((16, 3)), np.arange(16).reshape(1, 4, 4), Unit.M, name="\ud800")
    with pytest.raises(InputError, match="which is no character"):
        atlas_json.write(atlas)


def put(*path: Any) -> Callable[[dict[str, Any]], None]:
    """Set the member at all but the last of `path` to its last."""

    def change(members: dict[str, Any]) -> None:
        *keys, last, value = path
        target: Any = members
        for key in keys:
            target = target[key]
        target[last] = value

    return change


def drop(*path: Any) -> Callable[[dict[str, Any]], None]:
    def change(members: dict[str, Any]) -> None:
        target: Any = members
        for key in path[:-1]:
            target = target[key]
        del target[path[-1]]

    return change


def both(*changes: Callable[[dict[str, Any]], None]) -> Callable[[dict[str, Any]], None]:
    def change(members: dict[str, Any]) -> None:
        for each in changes:
            each(members)

    return change


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (drop("format"), 'is not a bodymeasure atlas file; expected "format": "bodymeasure atlas"'),
        (put("format", "gltf"), "is not a bodymeasure atlas file; .* got 'gltf'"),
        (put("version", 2), "has version 2; this bodymeasure reads version 1; update whichever"),
        (drop("version"), "has version None; this bodymeasure reads version 1"),
        (put("version", "1"), r"Expected `int \| null`, got `str` - at `\$.version`"),
        (drop("unit"), 'has no unit; add a line such as "unit": "cm" .one of m, cm, mm, inch'),
        (put("unit", None), "has no unit; add a line"),
        (put("unit", "furlong"), "unknown unit 'furlong'; expected one of m, cm, mm, inch"),
        (put("unit", 3), r"Expected `str`, got `int` - at `\$.unit`"),
        (drop("points"), "missing required field `points`"),
        (drop("axes"), "missing required field `axes`"),
        (put("axes", "up", "z"), "axes: up is 'z'; expected one of"),
        (put("axes", "up", "-y"), "lie along the same axis"),
        (put("color", "red"), "contains unknown field `color`"),
        (put("patches", 1, "color", "red"), r"patch 1 \('hip right'\): .*unknown field `color`"),
        (
            put("patches", 1, "points", [[0, 1, 2, 3]] * 3),
            r"patch 1 \('hip right'\): expected 4 rows of 4 .*; got 3",
        ),
        (
            put("patches", 0, "points", 2, [0, 1, 2]),
            r"patch 0 \('hip left'\): expected 4 rows of 4 .*; got 3",
        ),
        (put("patches", 0, "points", 2, 1, 1.5), r"\('hip left'\): Expected `int`, got `float`"),
        (put("patches", 0, "points", 2, 1, -1), r"\('hip left'\): Expected `int` >= 0"),
        (put("patches", 0, "points", 2, 1, 2**64), r"\('hip left'\): Expected `int` <= "),
        (
            put("patches", 0, "points", 2, 1, 28),
            r"patch 0 \('hip left'\) refers to control point 28, .* 0 to 27",
        ),
        (put("patches", 0, "name", "hip right"), "two patches are named 'hip right'"),
        (both(put("patches", []), put("landmarks", {})), "the atlas has no patch"),
        (put("points", 5, [0.0, 1.0]), "control point 5: .* of length 3, got 2"),
        (put("points", 5, [0.0, 1.0, None]), "control point 5: Expected `float`, got `null`"),
        (put("points", 5, [0.0, 1.0, "2"]), "control point 5: Expected `float`, got `str`"),
        (put("points", 5, [0.0, 1.0, 10**400]), "control point 5: Number out of range"),
        (put("points", []), "refers to control point 0"),
        (put("landmarks", "c7", "patch", "hip"), "landmark 'c7' lies on patch 'hip', which is not"),
        (put("landmarks", "c7", "u", 1.1), r"landmark 'c7' has \(u, v\) = \(1.1, 0.5\)"),
        (drop("landmarks", "c7", "v"), "landmark 'c7': .*missing required field `v`"),
        (put("provenance", "year", 2020), "Expected `str`, got `int`"),
    ],
)
def test_a_fault_is_named_with_its_place(
    change: Callable[[dict[str, Any]], None], message: str
) -> None:
    members = json.loads(VALID)
    change(members)
    with pytest.raises(InputError, match=f"^body.atlas: .*{message}"):
        atlas_json.read(json.dumps(members).encode(), "body.atlas")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "body.atlas: is empty; expected a bodymeasure atlas file"),
        (b" \n\t", "body.atlas: is empty"),
        (VALID[:200], "body.atlas, line 1?[0-9]: is not valid JSON .*; the file may have been cut"),
        (VALID + b"}", "body.atlas, line 4[0-9]: is not valid JSON .Extra data"),
        (VALID.replace(b"1.0", b"NaN", 1), "body.atlas, line [0-9]+: NaN is not a number"),
        (
            VALID.replace(b"1.0", b"-Infinity", 1),
            "line [0-9]+: -Infinity is not a number; expected",
        ),
        (VALID.replace(b"1.0", b"1e999", 1), "control point 9: Number out of range|Number out of"),
        (b"\x89PNG\r\n\x1a\n\x00\x01\xff", "body.atlas: is not text in UTF-8; expected JSON"),
        (VALID.decode().encode("utf-16"), "body.atlas: is not text in UTF-8; expected JSON"),
        (VALID.replace(b"nobody", b"n\xf6body"), "body.atlas: "),
        (b"[" * 100_000, "body.atlas: "),
        (b'{"format": ' + b"[" * 100_000, "body.atlas: "),
        (b'{"ignored": ' + b"[" * 100_000, "body.atlas: is nested too deeply"),
        (b"[]", "body.atlas: Expected `object`, got `array`; `bodymeasure docs atlas_format`"),
        (b"null", "body.atlas: Expected `object`, got `null`"),
        (b"o body\nv 0 0 0\n", "body.atlas, line 1: is not valid JSON"),
    ],
)
def test_what_is_no_atlas_is_refused(content: bytes, message: str) -> None:
    with pytest.raises(InputError, match=message):
        atlas_json.read(content, "body.atlas")


def test_the_line_of_a_fault_is_the_files() -> None:
    lines = VALID.split(b"\n")
    lines[20] = lines[20].replace(b"0.0", b"NaN", 1)
    with pytest.raises(InputError, match=r"body.atlas, line 21: NaN"):
        atlas_json.read(b"\n".join(lines), "body.atlas")


def assert_read_or_refused(content: bytes) -> None:
    try:
        atlas = atlas_json.read(content, "body.atlas")
    except InputError as error:
        message = str(error)
    else:
        assert np.isfinite(atlas.control_points).all()
        return
    assert message.startswith("body.atlas")


@given(st.integers(0, len(VALID)), st.integers(0, 10), st.binary(max_size=10))
def test_garbled_bytes_are_read_or_refused(start: int, length: int, bytes_: bytes) -> None:
    assert_read_or_refused(VALID[:start] + bytes_ + VALID[start + length :])


@given(st.binary(max_size=200))
def test_any_bytes_are_refused(content: bytes) -> None:
    with pytest.raises(InputError, match=r"^body.atlas"):
        atlas_json.read(content, "body.atlas")


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda values: st.lists(values, max_size=4) | st.dictionaries(st.text(max_size=5), values),
    max_leaves=8,
)


@given(data=st.data())
def test_any_member_may_be_anything(data: st.DataObject) -> None:
    members = json.loads(VALID)
    target: Any = members
    while True:
        keys = sorted(target) if isinstance(target, dict) else range(len(target))
        key = data.draw(st.sampled_from(keys))
        inner = target[key]
        if not (isinstance(inner, dict | list) and inner and data.draw(st.booleans())):
            break
        target = inner
    target[key] = data.draw(json_values)
    assert_read_or_refused(json.dumps(members).encode("utf-8", "surrogatepass"))
