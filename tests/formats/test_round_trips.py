from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.files.format_atlases import TEXT, UNIT, atlases, body_like, read, write
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure import (
    Atlas,
    AtlasPoint,
    Axes,
    GivenLength,
    InputError,
    Unit,
    read_atlas,
    write_atlas,
)
from bodymeasure._typing import Ints
from bodymeasure.atlas import edge_table
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.patches import unique_names

LOSSLESS = ("atlas", "npz")
RATIONAL = ("atlas", "npz", "bez", "obj", "geomdl")


def joints(atlas: Atlas) -> Ints:
    """For each side the number of the first that lies on the same edge."""
    edge = edge_table(atlas.index).edge.ravel()
    _, first, number = np.unique(edge, return_index=True, return_inverse=True)
    return np.asarray(first[number])


@pytest.mark.parametrize("form", [*LOSSLESS, *TEXT])
@given(atlas=atlases())
def test_patches_come_back_to_the_last_bit(form: str, atlas: Atlas) -> None:
    content = write(atlas, form)
    back = read(content, form)
    assert back.control_points.tobytes() == atlas.control_points.tobytes()
    assert back.digest == atlas.digest
    # The sides are joined as before, and no others are.
    np.testing.assert_array_equal(joints(back), joints(atlas))
    assert write(back, form) == content or form == "obj"


@pytest.mark.parametrize("form", RATIONAL)
@given(atlas=atlases(rational=True))
def test_rational_patches_come_back(form: str, atlas: Atlas) -> None:
    back = read(write(atlas, form), form)
    assert atlas.weights is not None
    assert back.weights is not None
    # Geomview stores points times their weights.
    np.testing.assert_allclose(back.weights, atlas.weights, rtol=1e-15)
    expected = atlas.points[atlas.index]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(back.points[back.index], expected, rtol=0, atol=4e-16 * scale)
    np.testing.assert_array_equal(joints(back), joints(atlas))


def test_what_a_format_has_no_room_for_is_refused() -> None:
    rational = replace(body_like(1, 1), weights=np.linspace(1.0, 2.0, 16).reshape(1, 4, 4))
    with pytest.raises(InputError, match="rational atlas cannot be written to a BPT file"):
        write(rational, "bpt")
    side = np.linspace(0.0, 1.0, 9)
    net = np.stack(np.meshgrid(side, side, [0.0], indexing="ij"), axis=-1)[:, :, 0]
    with pytest.raises(InputError, match="degree 8 cannot be written to a Geomview file"):
        write(Atlas.from_control_points(net, UNIT), "bez")
    assert read(write(Atlas.from_control_points(net, UNIT), "bpt"), "bpt").degree == 8


NAMED = replace(
    body_like(1, 3),
    patch_names=("hip left", "hip right", "näve #1"),
    regions=("hip", "", "back upper"),
    landmarks={"c7": AtlasPoint(1, 0.25, 0.5)},
    axes=Axes("+y", "+z"),
    name="Somebody",
    provenance={"author": "nobody"},
    given={"stature": GivenLength(165.0, 0.01, 0.3, "By hand."), "head_girth": GivenLength(56.0)},
)


@pytest.mark.parametrize("form", LOSSLESS)
def test_our_formats_keep_everything(form: str) -> None:
    back = read(write(NAMED, form), form)
    for field in (
        "unit",
        "patch_names",
        "regions",
        "landmarks",
        "axes",
        "name",
        "provenance",
        "given",
    ):
        assert getattr(back, field) == getattr(NAMED, field), field
    np.testing.assert_array_equal(back.index, NAMED.index)


def test_obj_keeps_names_and_regions() -> None:
    back = read(write(NAMED, "obj"), "obj")
    assert back.patch_names == NAMED.patch_names
    assert back.regions == NAMED.regions


def test_geomdl_keeps_names() -> None:
    assert read(write(NAMED, "geomdl"), "geomdl").patch_names == NAMED.patch_names


@pytest.mark.parametrize("name", ["a  b", "a\\", "a\ud800"])
def test_names_that_an_obj_file_cannot_hold_are_refused(name: str) -> None:
    atlas = replace(body_like(1, 1), patch_names=(name,))
    with pytest.raises(InputError, match=r"the patch name .* cannot be written to a Wavefront OBJ"):
        write(atlas, "obj")


@pytest.mark.parametrize("form", ["npz", "geomdl"])
def test_characters_that_utf_8_has_not_are_refused(form: str) -> None:
    atlas = replace(body_like(1, 1), patch_names=("\ud800",))
    with pytest.raises(InputError, match="no character; expected text that UTF-8 can write"):
        write(atlas, form)


@given(
    names=st.lists(
        st.sampled_from(["arm", "arm 0", "arm 1", "", " ", "leg", "patch 0"]), max_size=8
    )
)
def test_names_become_unique_and_unique_ones_stay(names: list[str]) -> None:
    made = unique_names(names)
    assert len(set(made)) == len(names)
    for old, new in zip(names, made, strict=True):
        assert new == old if names.count(old) == 1 and old.strip() else new.startswith(old.strip())


@pytest.mark.parametrize("form", TEXT)
def test_the_unit_must_be_given(form: str) -> None:
    content = write(body_like(1, 1), form)
    with pytest.raises(InputError, match=r"^file: .* says no unit.*--file-unit on the"):
        read(content, form, ReadOptions())
    axes = Axes("+y", "+z")
    atlas = read(content, form, ReadOptions(unit=Unit.INCH, axes=axes))
    assert (atlas.unit, atlas.axes) == (Unit.INCH, axes)


@pytest.mark.parametrize("form", LOSSLESS)
def test_a_unit_that_a_file_has_is_not_overruled(form: str) -> None:
    content = write(NAMED, form)
    with pytest.raises(
        InputError, match=r"^file: is in cm, but the unit m was given; leave it out"
    ):
        read(content, form, ReadOptions(unit=Unit.M))
    with pytest.raises(InputError, match=r"has up \+y and front \+z, but others were given"):
        read(content, form, ReadOptions(axes=Axes()))
    with pytest.raises(InputError, match="is joined already; leave the tolerance out"):
        read(content, form, ReadOptions(tolerance=1.0))
    same = ReadOptions(unit=Unit.CM, axes=NAMED.axes)
    assert read(content, form, same).digest == NAMED.digest


@pytest.mark.parametrize("form", TEXT)
def test_edges_within_a_tolerance_are_joined_if_asked(form: str) -> None:
    loose = body_like(1, 2).control_points.copy()
    loose[1] += 1e-3
    content = write(Atlas.from_control_points(loose, UNIT), form)
    assert len(read(content, form).points) == 32
    assert len(read(content, form, ReadOptions(unit=UNIT, tolerance=2e-3)).points) == 28


def test_files_are_chosen_by_extension_or_format(tmp_path: Path) -> None:
    folder = tmp_path
    atlas = body_like(2, 2)
    for name in ("a.bpt", "a.BEZ", "a.bbp", "a.obj", "a.json", "a.npz", "a.atlas"):
        write_atlas(atlas, folder / name)
        unit = None if name.endswith(("npz", "atlas")) else "cm"
        assert read_atlas(folder / name, unit=unit).digest == atlas.digest
    write_atlas(atlas, folder / "b.txt", format="bpt")
    assert (folder / "b.txt").read_bytes() == (folder / "a.bpt").read_bytes()
    assert read_atlas(folder / "b.txt", unit="cm", format="bpt").digest == atlas.digest
    with pytest.raises(InputError, match="unknown format 'stl'; expected one of atlas, npz, bpt"):
        read_atlas(folder / "b.txt", format="stl")
    with pytest.raises(InputError, match=r"can only be read; expected one of \.atlas, \.npz"):
        write_atlas(atlas, folder / "c.obj", format="obj-mesh")


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"unit": "ft"}, "unknown unit 'ft'"),
        ({"unit": "cm", "up": "+y"}, r"front \(-y\) lie along the same axis.*; give front too"),
        ({"unit": "cm", "front": "+z"}, "lie along the same axis.*; give up too"),
        ({"unit": "cm", "up": "+y", "front": "-y"}, "they must be perpendicular$"),
        ({"unit": "cm", "tolerance": -1.0}, "the tolerance is -1.0; expected a length"),
    ],
)
def test_wrong_options_are_told(tmp_path: Path, given: dict[str, object], message: str) -> None:
    path = tmp_path / "a.bpt"
    write_atlas(body_like(1, 1), path)
    with pytest.raises(InputError, match=message):
        read_atlas(path, **given)  # type: ignore[arg-type]


def test_groups_are_chosen_by_region_or_by_a_word_of_it() -> None:
    content = write(NAMED, "atlas")
    upper = read(content, "atlas", ReadOptions(groups=("upper",)))
    assert upper.patch_names == ("näve #1",)
    assert len(upper.points) == 16
    assert upper.landmarks == {}
    both = read(content, "atlas", ReadOptions(groups=("back upper", "hip")))
    assert both.patch_names == ("hip left", "näve #1")
    np.testing.assert_array_equal(both.control_points, NAMED.control_points[[0, 2]])
    with pytest.raises(
        InputError,
        match=r"^file: no patch is in a group 'arm'; there are: back, back upper, hip, upper$",
    ):
        read(content, "atlas", ReadOptions(groups=("arm",)))
    with pytest.raises(InputError, match="the file names no groups"):
        read(write(body_like(1, 1), "atlas"), "atlas", ReadOptions(groups=("arm",)))
