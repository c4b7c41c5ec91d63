import numpy as np
import pytest
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas
from bodymeasure.scene import SIDES, body_scene, body_views, patch_scene, patch_view
from bodymeasure.scene.drawing.raster import rasterize


@pytest.mark.parametrize("side", SIDES)
def test_every_side_frames_the_whole_body_upright(body: Atlas, side: str) -> None:
    scene = body_scene(straight_survey(body))
    view = body_views(scene, body.axes)[side]
    size = view.size(500)
    pixels, _ = view.project(scene.surface.points, size)
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    assert (low > 5).all()
    assert (high < np.array(size) - 5).all()
    # It fills the picture but for its margins, and stands on its feet.
    assert high[1] - low[1] > 0.95 * size[1]
    neck, _ = view.project(body.position(body.landmarks["front neck point"]), size)
    knee, _ = view.project(body.position(body.landmarks["patella point left"]), size)
    assert neck[1] < knee[1]


def test_sides_are_the_wearers(body: Atlas) -> None:
    views = body_views(body_scene(straight_survey(body)), body.axes)
    left, right = (
        body.position(body.landmarks[f"bust point {side}"]) for side in ("left", "right")
    )
    nearer = {}
    for side, view in views.items():
        pixels, depth = view.project(np.array([left, right]), view.size(500))
        nearer[side] = depth[0] > depth[1]
        if side == "front":  # facing us, the wearer's left is on our right
            assert pixels[0, 0] > pixels[1, 0]
        if side == "back":
            assert pixels[0, 0] < pixels[1, 0]
    assert nearer["left"]
    assert not nearer["right"]


def test_all_sides_have_one_scale(body: Atlas) -> None:
    views = body_views(body_scene(straight_survey(body)), body.axes)
    assert len({view.height for view in views.values()}) == 1


@pytest.mark.parametrize("patch", range(0, 376, 75))
def test_a_patch_is_seen_from_outside_and_whole(body: Atlas, patch: int) -> None:
    scene = patch_scene(straight_survey(body), patch)
    view = patch_view(scene, body.axes)
    assert view.width == view.height
    surface = scene.surface
    # The atlas's normals point outwards.
    assert surface.normals[~surface.faded].mean(axis=0) @ view.towards > 0.0
    pixels, _ = view.project(surface.points[~surface.faded], view.size(400))
    assert (pixels > 20).all()
    assert (pixels < 380).all()
    # Nothing that is far in front of the patch is drawn.
    size = view.size(200)
    places, depth = view.project(surface.points, size)
    buffer = rasterize(places, depth, surface.triangles, size, nearest=view.nearest)
    assert buffer.depth.max() <= depth[~surface.faded].max() + 0.1 * view.height + 1e-12
    # All of the patch that nothing hides is drawn.
    assert view.nearest >= depth[~surface.faded].max()


def test_a_patch_of_an_inside_out_atlas_is_seen_from_outside_too(body: Atlas) -> None:
    inside_out = Atlas(body.points, body.index.swapaxes(1, 2), body.unit)
    view = patch_view(patch_scene(straight_survey(body), 40), body.axes)
    turned = patch_view(patch_scene(straight_survey(inside_out), 40), body.axes)
    np.testing.assert_allclose(turned.towards, view.towards, atol=1e-9)
