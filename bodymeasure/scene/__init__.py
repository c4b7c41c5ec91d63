"""Pictures of a measured body: the scene as plain data, and renderers that draw it.

Importing this loads neither VTK nor matplotlib; drawing does.
"""

from bodymeasure.scene.camera import SIDES, View, body_views, patch_view
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.diagonals.build import body_scene, patch_scene
from bodymeasure.scene.diagonals.gallery import Pictures, pictures
from bodymeasure.scene.diagonals.overview import body_overview
from bodymeasure.scene.drawing.opengl_check import Choice, choose_renderer
from bodymeasure.scene.figures.canvas import png
from bodymeasure.scene.figures.color_bar import color_bar
from bodymeasure.scene.model import (
    BodyScene,
    Label,
    PathKind,
    Paths,
    Polylines,
    Surface,
    TapeLine,
    TapeScene,
)
from bodymeasure.scene.tapes.build import tapes_scene
from bodymeasure.scene.tapes.gallery import TapePictures, tape_pictures, tapes_overview

__all__ = [
    "SIDES",
    "BodyScene",
    "Choice",
    "ColorScale",
    "Label",
    "PathKind",
    "Paths",
    "Pictures",
    "Polylines",
    "Surface",
    "TapeLine",
    "TapePictures",
    "TapeScene",
    "View",
    "body_overview",
    "body_scene",
    "body_views",
    "choose_renderer",
    "color_bar",
    "patch_scene",
    "patch_view",
    "pictures",
    "png",
    "tape_pictures",
    "tapes_overview",
    "tapes_scene",
]
