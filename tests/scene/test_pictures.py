import io
from dataclasses import replace

import numpy as np
import pytest
from helpers.charts.straight_survey import straight_survey
from PIL import Image

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.scene import body_overview, body_views, pictures
from bodymeasure.scene.diagonals.build import body_scene
from bodymeasure.scene.diagonals.strokes import BODY_STYLE


def test_all_pictures_of_a_small_atlas(square: Atlas, monkeypatch: pytest.MonkeyPatch) -> None:
    style = replace(BODY_STYLE, height=200)
    monkeypatch.setattr("bodymeasure.scene.diagonals.gallery.BODY_STYLE", style)
    seen: list[str] = []
    shots = pictures(straight_survey(square), [0], renderer="software", advance=seen.append)
    assert seen == ["front", "back", "left", "right", "patch 0"]
    assert list(shots.body) == seen[:4]
    assert (shots.renderer, shots.note) == ("software", "")
    front = Image.open(io.BytesIO(shots.body["front"]))
    assert front.format == "PNG"
    assert front.size == (200, 200)
    closeup = np.asarray(Image.open(io.BytesIO(shots.closeups[0])))
    assert closeup.shape == (640, 640, 3)
    # The scale bar is 2 cm long; the square of 10 cm is drawn over 1 / 1.36 of the picture.
    dark = np.asarray((closeup[600:620] < 80).all(axis=-1).any(axis=0))
    assert dark[:300].sum() == pytest.approx(640 * 2 / 13.6, abs=4)


def test_an_unknown_patch_is_named(square: Atlas) -> None:
    with pytest.raises(InputError, match="no patch 7 to draw; the patches are numbered 0 to 0"):
        pictures(straight_survey(square), [7], renderer="software")


def test_an_unknown_renderer_is_named(square: Atlas) -> None:
    with pytest.raises(InputError, match="renderer is 'povray'"):
        pictures(straight_survey(square), renderer="povray")


@pytest.mark.slow
def test_the_overview_holds_four_sides_side_by_side(body: Atlas) -> None:
    survey = straight_survey(body)
    image = np.asarray(Image.open(io.BytesIO(body_overview(survey, renderer="software"))))
    views = body_views(body_scene(survey), body.axes)
    assert image.shape[1] > sum(view.size(900)[0] for view in views.values())
    # There are four bodies, with white between them.
    inked = (image[44:944] < 250).any(axis=(0, 2))
    assert np.count_nonzero(np.diff(inked.astype(int)) == 1) == 4
