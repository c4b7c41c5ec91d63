"""Tests that both renderers draw the same picture from one description."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import scipy.ndimage

from bodymeasure._typing import Bools, Ints
from bodymeasure.atlas import Unit
from bodymeasure.scene import BodyScene, ColorScale, TapeScene, View, patch_view
from bodymeasure.scene.diagonals.annotate import annotated
from bodymeasure.scene.diagonals.build import patch_scene
from bodymeasure.scene.diagonals.strokes import BODY_STYLE, CLOSEUP_STYLE, scene_picture
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, opengl_trouble
from bodymeasure.scene.drawing.picture import Draw, Picture, Stroke
from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.tapes.closeup import closeup
from bodymeasure.scene.tapes.mesh import forward, tape_mesh

pytestmark = pytest.mark.slow
# How far a silhouette may be moved, in pixels.
SHIFT = 1
# Where nothing has an edge, colors may differ by this, of 255.
COLOR = 3


@pytest.fixture(scope="module")
def renderers() -> Iterator[tuple[Draw, Draw]]:
    if opengl_trouble():
        pytest.skip(opengl_trouble())
    with RENDERERS[SOFTWARE]() as software, RENDERERS[PYVISTA]() as pyvista:
        yield software, pyvista


def images(renderers: tuple[Draw, Draw], picture: Picture) -> tuple[Ints, Ints]:
    ours, theirs = (draw(picture).astype(np.int64) for draw in renderers)
    assert ours.shape == theirs.shape
    return ours, theirs


def inked(image: Ints) -> Bools:
    return np.asarray((image < 250).any(axis=-1))


def flat(image: Ints) -> Bools:
    """Find the pixels of a picture that have no edge around them."""
    spread = scipy.ndimage.maximum_filter(image, (3, 3, 1)) - scipy.ndimage.minimum_filter(
        image, (3, 3, 1)
    )
    return np.asarray(spread.max(axis=-1) < 12)


@pytest.mark.parametrize("side", ["front", "left"])
def test_silhouettes_and_colors_are_the_same(
    renderers: tuple[Draw, Draw],
    survey_scene: BodyScene,
    views: Mapping[str, View],
    side: str,
) -> None:
    view = views[side]
    ours, theirs = images(renderers, Picture(survey_scene.surface, view, view.size(600)))
    for one, other in ((ours, theirs), (theirs, ours)):
        reach = scipy.ndimage.binary_dilation(inked(other), iterations=SHIFT)
        assert not (inked(one) & ~reach).any()
    smooth = flat(ours)
    assert (smooth & inked(ours)).sum() > 0.5 * inked(ours).sum()
    assert np.abs(ours - theirs)[smooth].max() <= COLOR


def test_both_cut_at_the_same_plane(
    renderers: tuple[Draw, Draw], survey_scene: BodyScene, views: Mapping[str, View]
) -> None:
    whole = views["front"]
    cut = replace(whole, nearest=0.05 * whole.height)
    ours, theirs = images(renderers, Picture(survey_scene.surface, cut, cut.size(600)))
    assert (np.abs(ours - theirs).max(axis=-1) > 40).mean() < 0.002
    # The breasts are cut off, the arms are not.
    uncut = renderers[0](Picture(survey_scene.surface, whole, whole.size(600)))
    changed = (np.abs(uncut - ours).max(axis=-1) > COLOR).mean()
    assert 0.005 < changed < 0.2


def test_lines_are_hidden_alike(
    renderers: tuple[Draw, Draw], survey_scene: BodyScene, views: Mapping[str, View]
) -> None:
    scale = ColorScale.of(survey_scene.paths)
    style = replace(BODY_STYLE, height=600)
    ours, theirs = images(renderers, scene_picture(survey_scene, views["front"], scale, style))
    assert (np.abs(ours - theirs).max(axis=-1) > 40).mean() < 0.001


def test_tubes_are_the_same(
    renderers: tuple[Draw, Draw], scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    view = seen["front"].view
    tubes = tape_mesh(scene.tapes, 0.006, forward(scene, scene.tapes, view))
    picture = Picture(scene.surface, view, view.size(420), tubes=tubes)
    ours, theirs = images(renderers, picture)
    assert (np.abs(ours - theirs).max(axis=-1) > 40).mean() < 0.001


def test_labels_and_marks_are_the_same(
    renderers: tuple[Draw, Draw], scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    picture = closeup(scene, "girth_bust_point_left", seen["front"])
    assert len(picture.texts) > 1
    labeled = images(renderers, picture)
    plain = images(renderers, replace(picture, marks=(), texts=()))
    changed = [(one != other).any(axis=-1) for one, other in zip(labeled, plain, strict=True)]
    assert changed[0].sum() > 1000
    # A pixel of a label's white rim is not changed where it was nearly white.
    assert (changed[0] != changed[1]).sum() < 0.01 * changed[0].sum()
    both = changed[0] & changed[1] & flat(plain[0])
    assert np.abs(labeled[0] - labeled[1])[both].max() <= COLOR


def test_a_new_mark_is_drawn_by_both(
    renderers: tuple[Draw, Draw], survey_scene: BodyScene, views: Mapping[str, View]
) -> None:
    view = views["front"]
    surface = survey_scene.surface
    middle, extent = surface.points.mean(axis=0), np.ptp(surface.points, axis=0).max()
    angle = np.linspace(0.0, 4.0 * np.pi, 200)[:, None]
    # A helix around the body, half of which the body hides.
    helix = middle + extent * (
        0.3 * (np.cos(angle) * view.right + np.sin(angle) * view.towards)
        + (angle / angle.max() - 0.5) * 0.6 * view.up
    )
    stroke = Stroke(helix[None], np.array([[1.0, 0.0, 1.0]]), 3.0)
    picture = Picture(surface, view, view.size(400), strokes=[stroke])
    magenta = [
        (image[..., 0] - image[..., 1] > 128) & (image[..., 2] > 128)
        for image in images(renderers, picture)
    ]
    assert magenta[0].sum() > 300
    assert (magenta[0] != magenta[1]).sum() < 0.01 * magenta[0].sum()


def test_closeups_of_patches_are_the_same(renderers: tuple[Draw, Draw], survey: Any) -> None:
    part = patch_scene(survey, 100)
    view = patch_view(part, survey.atlas.axes)
    style = replace(CLOSEUP_STYLE, height=300)
    picture = scene_picture(part, view, ColorScale.of(part.paths), style)
    ours, theirs = images(renderers, annotated(picture, part.labels, Unit.M))
    assert (np.abs(ours - theirs).max(axis=-1) > 40).mean() < 0.001
