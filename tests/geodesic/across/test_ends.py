"""The ends of paths: points, landmarks and positions, and those that are refused."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas

import bodymeasure as bm
from bodymeasure.atlas import Atlas, AtlasPoint, Unit


def two_parts() -> Atlas:
    atlas = grid_atlas(1, 2)
    points = np.vstack([atlas.points, atlas.points + np.array([5.0, 0.0, 0.0])])
    index = np.concatenate([atlas.index, atlas.index + len(atlas.points)])
    return Atlas(points, index, Unit.CM, patch_names=("left", "right", "far left", "far right"))


def test_separate_parts_are_refused() -> None:
    with pytest.raises(bm.InputError, match=r"the start is on 'right' and the end on 'far left'"):
        bm.geodesic_between(two_parts(), AtlasPoint(1, 0.5, 0.5), AtlasPoint(2, 0.5, 0.5))
    with pytest.raises(bm.InputError, match=r"via point 0 on 'far right'.* 2 separate parts"):
        bm.geodesic_between(
            two_parts(),
            AtlasPoint(0, 0.5, 0.5),
            AtlasPoint(1, 0.5, 0.5),
            via=[AtlasPoint(3, 0.1, 0.1)],
        )


def test_parts_that_meet_in_a_corner_only_are_separate() -> None:
    square = grid_atlas(2, 2)
    atlas = Atlas(square.points, square.index[[0, 3]], Unit.CM)
    with pytest.raises(bm.InputError, match="no seams join"):
        bm.geodesic_between(atlas, AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5))


@pytest.mark.parametrize(
    ("point", "message"),
    [
        (AtlasPoint(9, 0.5, 0.5), r"the end is on patch 9, .* numbered 0 to 3"),
        (AtlasPoint(-1, 0.5, 0.5), r"the end is on patch -1"),
        (AtlasPoint("left", 0.5, 0.5), r"the end is AtlasPoint.*expected the number of a patch"),  # type: ignore[arg-type]
        (AtlasPoint(1.5, 0.5, 0.5), r"patch=1.5.*expected the number of a patch"),  # type: ignore[arg-type]
        (AtlasPoint(0, None, 0.5), r"u=None.*and u and v in \[0, 1\]"),  # type: ignore[arg-type]
        (AtlasPoint(0, 1.5, 0.5), r"the end has \(u, v\) = \(1.5, 0.5\)"),
        (AtlasPoint(0, 0.5, float("nan")), r"expected both in \[0, 1\]"),
        ((0, 0.5), r"expected three finite numbers, a landmark's name or an AtlasPoint"),
        ((0, 0.5, 0.5), r"the end at \(0, 0.5, 0.5\) cm is 0.5 cm from the surface, more than"),
    ],
)
def test_points_that_are_not_on_the_atlas(point: AtlasPoint, message: str) -> None:
    with pytest.raises(bm.InputError, match=message):
        bm.geodesic_between(two_parts(), AtlasPoint(0, 0.5, 0.5), point)


def test_other_mistakes() -> None:
    atlas = two_parts()
    ends = AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5)
    with pytest.raises(bm.InputError, match="on_failure is 'ignore'"):
        bm.geodesic_between(atlas, *ends, on_failure="ignore")  # type: ignore[arg-type]
    for via in ("bust point left", ends[0], None):
        with pytest.raises(bm.InputError, match=r"via is .*; expected a list of locations"):
            bm.geodesic_between(atlas, *ends, via=via)  # type: ignore[arg-type]
    with pytest.raises(bm.InputError, match="starts is 'left'; expected a list"):
        bm.geodesics_between(atlas, "left", "left")
    with pytest.raises(bm.InputError, match="the loop is 'left'; expected a list"):
        bm.contracted_loop(atlas, "left")
    path = bm.geodesic_between(atlas, *ends)
    for wrong in (1.5, [0.0, float("nan")], "half"):
        with pytest.raises(bm.InputError, match="path parameters"):
            path.path(wrong)


def test_ends_are_given_by_name_or_by_position() -> None:
    points = {"start": AtlasPoint(0, 0.2, 0.3), "via": AtlasPoint(0, 0.9, 0.9)}
    atlas = replace(grid_atlas(2, 2), landmarks=points | {"end": AtlasPoint(3, 0.4, 0.6)})
    known = bm.geodesic_between(atlas, atlas.landmarks["start"], atlas.landmarks["end"])
    above = atlas.position(atlas.landmarks["end"]) + np.array([0.0, 0.0, 0.01])
    assert bm.geodesic_between(atlas, "start", "end").points == known.points
    assert bm.geodesic_between(atlas, "start", above).length == pytest.approx(known.length)
    assert len(bm.geodesic_between(atlas, "start", "end", ["via"]).leg_ends) == 3
    assert bm.geodesics_between(atlas, ["start"], ["end"])[0].length == known.length
    assert bm.geodesic_alternatives(atlas, "start", "end", 1)[0].length == known.length
    with pytest.raises(bm.InputError, match=r"no landmark 'ende'; did you mean 'end'"):
        bm.geodesic_between(atlas, "start", "ende")
    with pytest.raises(bm.InputError, match=r"via point 0 at .* from the surface, more than"):
        bm.geodesic_between(atlas, "start", "end", [above + 1.0])


@pytest.mark.parametrize("factor", [1e100, 1e-100])
def test_sizes_at_which_areas_overflow_are_refused(factor: float) -> None:
    atlas = grid_atlas(1, 2)
    with pytest.raises(bm.InputError, match=r"extends over .* choose another unit"):
        bm.geodesic_between(
            replace(atlas, points=factor * atlas.points),
            AtlasPoint(0, 0.5, 0.5),
            AtlasPoint(1, 0.5, 0.5),
        )
