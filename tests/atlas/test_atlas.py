from collections.abc import Mapping
from dataclasses import FrozenInstanceError, replace
from typing import Any

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

from bodymeasure import Atlas, AtlasPoint, InputError, Unit, load_sample

NET = np.stack(np.meshgrid(np.arange(4.0), np.arange(4.0), [0.0], indexing="ij"), -1)[:, :, 0]
POINTS, INDEX = NET.reshape(-1, 3), np.arange(16).reshape(1, 4, 4)


def test_control_points_are_gathered_and_read_only() -> None:
    atlas = Atlas(POINTS, INDEX, Unit.CM)
    assert len(atlas) == 1
    assert atlas.unit is Unit.CM
    assert atlas.patch_names == ("patch 0",)
    assert atlas.regions == ("",)
    np.testing.assert_array_equal(atlas.control_points[0], NET)
    for array in (atlas.points, atlas.index, atlas.control_points):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    with pytest.raises(FrozenInstanceError):
        atlas.name = "other"  # type: ignore[misc]


def test_an_atlas_does_not_follow_the_arrays_it_was_made_from() -> None:
    points, index = POINTS.copy(), INDEX.copy()
    atlas = Atlas(points, index, Unit.CM)
    points[:], index[:] = 7.0, 3
    np.testing.assert_array_equal(atlas.control_points[0], NET)


def test_patches_need_not_share_points() -> None:
    atlas = Atlas.from_control_points([NET, NET + 1.0], "m")
    np.testing.assert_array_equal(atlas.control_points, [NET, NET + 1.0])
    assert len(Atlas.from_control_points(NET, "m")) == 1


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"unit": "km"}, "unknown unit 'km'; expected one of m, cm, mm, inch"),
        ({"unit": None}, "unknown unit None"),
        ({"index": INDEX[0]}, r"patch index has shape \(4, 4\); expected \(patches, 4, 4\)"),
        ({"index": INDEX[:, :3]}, r"shape \(1, 3, 4\); expected \(patches, 4, 4\)"),
        ({"index": INDEX[:0]}, "the atlas has no patch; expected at least one"),
        ({"index": [[[0, 1, 2, 3]] * 3 + [[0, 1, 2]]]}, "the patch index is ragged"),
        ({"index": INDEX * 1.0}, "the patch index holds float64; expected whole numbers"),
        ({"index": INDEX - 1}, "patch 0 refers to control point -1, .* numbered 0 to 15"),
        ({"index": INDEX + 1}, "patch 0 refers to control point 16, .* numbered 0 to 15"),
        ({"points": POINTS[:, :2]}, r"control points have shape \(16, 2\); expected \(n, 3\)"),
        ({"points": [["a", "b", "c"]] * 16}, "control points are not numbers"),
        ({"points": [[0.0], [0.0, 1.0]]}, "control points are not numbers"),
        (
            {"points": POINTS + np.array([np.nan, 0, 0])},
            r"point 0 is \[nan, .*finite.*\(16 such points\)",
        ),
        ({"points": POINTS - np.array([np.inf, 0, 0])}, "expected finite coordinates"),
        ({"patch_names": ("a", "b")}, "2 patch names for 1 patches; expected one each"),
        ({"regions": ("a", "b")}, "2 regions for 1 patches; expected one each"),
        (
            {"landmarks": {"c7": AtlasPoint(1, 0.5, 0.5)}},
            "landmark 'c7' lies on patch 1, .* 0 to 0",
        ),
        ({"landmarks": {"c7": AtlasPoint(-1, 0.5, 0.5)}}, "landmark 'c7' lies on patch -1"),
        (
            {"landmarks": {"c7": AtlasPoint(0, 1.5, 0.5)}},
            r"\(1.5, 0.5\); expected both in \[0, 1\]",
        ),
        ({"landmarks": {"c7": AtlasPoint(0, 0.5, float("nan"))}}, r"\(0.5, nan\); expected both"),
    ],
)
def test_bad_data_are_refused(changes: Mapping[str, Any], message: str) -> None:
    good: dict[str, Any] = {"points": POINTS, "index": INDEX, "unit": "cm"}
    with pytest.raises(InputError, match=message):
        Atlas(**{**good, **changes})


def test_names_must_be_unique() -> None:
    with pytest.raises(InputError, match="two patches are named 'arm'; patch names must be unique"):
        replace(grid_atlas(2, 1), patch_names=("arm", "arm"))


@pytest.mark.parametrize(
    "net", [np.zeros((3, 4, 3)), np.zeros((2, 2, 4, 4, 3)), np.zeros(3), [["a"]]]
)
def test_loose_patches_of_another_shape_are_refused(net: Any) -> None:
    with pytest.raises(InputError, match=r"expected \(4, 4, 3\) or \(patches, 4, 4, 3\)"):
        Atlas.from_control_points(net, "cm")


def test_patches_are_found_by_name() -> None:
    atlas = replace(grid_atlas(2, 1), patch_names=("left", "right"))
    assert atlas.patch_number("right") == 1
    with pytest.raises(InputError, match="no patch named 'middle'; expected one of left, right"):
        atlas.patch_number("middle")


def test_a_place_has_its_position() -> None:
    np.testing.assert_allclose(
        Atlas(POINTS, INDEX, Unit.CM).position(AtlasPoint(0, 0.5, 0.25)),
        [1.5, 0.75, 0.0],
        rtol=1e-15,
    )


def test_converting_scales_and_keeps_all_else() -> None:
    landmarks = {"c7": AtlasPoint(0, 0.5, 0.5)}
    atlas = Atlas(POINTS, INDEX, Unit.INCH, ("p",), ("r",), landmarks, name="n")
    converted = atlas.converted("mm")
    assert converted.unit is Unit.MM
    np.testing.assert_allclose(converted.points, POINTS * 25.4, rtol=1e-15)
    assert (converted.patch_names, converted.regions, converted.landmarks, converted.name) == (
        ("p",),
        ("r",),
        landmarks,
        "n",
    )


def test_the_digest_is_of_geometry_and_unit_alone() -> None:
    atlas = Atlas(POINTS, INDEX, Unit.CM)
    assert len(atlas.digest) == 64
    assert atlas.digest == replace(atlas, name="other", patch_names=("x",)).digest
    # These are the same patches with another numbering.
    assert atlas.digest == Atlas(POINTS[::-1], 15 - INDEX, Unit.CM).digest
    assert atlas.digest != replace(atlas, unit=Unit.MM).digest
    nudged = POINTS.copy()
    nudged[5, 2] = np.nextafter(0.0, 1.0)
    assert atlas.digest != replace(atlas, points=nudged).digest


@pytest.mark.parametrize("name", ["", "  ", "hip\nleft", "hip\x1b[31m"])
def test_a_patch_has_a_name_that_can_be_printed(name: str) -> None:
    with pytest.raises(InputError, match="expected a name on one line"):
        Atlas(POINTS, INDEX, Unit.CM, patch_names=(name,))


def test_landmarks_have_positions_by_their_names() -> None:
    body = load_sample("female_average")
    point = body.landmarks["crotch point"]
    assert body.landmark("crotch point") == point
    assert (body.position("crotch point") == body.position(point)).all()
    with pytest.raises(InputError, match="no landmark 'crotch'; did you mean 'crotch point'"):
        body.position("crotch")
    with pytest.raises(InputError, match="nor any other"):
        load_sample("paraboloid").position("crotch")
