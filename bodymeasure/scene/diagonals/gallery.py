"""All pictures of a survey."""

import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.scene.camera import View, body_views, cut_away, patch_view
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.diagonals.annotate import annotated
from bodymeasure.scene.diagonals.build import body_scene, patch_scene
from bodymeasure.scene.drawing import opengl, software
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, choose_renderer
from bodymeasure.scene.drawing.strokes import BODY_STYLE, CLOSEUP_STYLE, Style
from bodymeasure.scene.figures.color_bar import color_bar
from bodymeasure.scene.model import BodyScene

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

BODY_PIXELS = 1100
CLOSEUP_PIXELS = 640
# Of PNG files, from 1 to 9: more takes twice the time for a tenth of the size.
COMPRESSION = 4


class Renderer(Protocol):
    """Draws a scene; both renderers are such a function."""

    def __call__(
        self,
        scene: BodyScene,
        view: View,
        size: tuple[int, int],
        scale: ColorScale | None,
        style: Style,
    ) -> NDArray[np.uint8]:
        """A picture of a scene; see `software.render`."""


RENDERERS: Mapping[str, Renderer] = {PYVISTA: opengl.render, SOFTWARE: software.render}


@dataclass(frozen=True)
class Pictures:
    """The pictures of a survey.

    Parameters
    ----------
    body : mapping of str to bytes
        PNG files by side: ``front``, ``back``, and the wearer's ``left`` and ``right``. All are
        equally high and to one scale.
    closeups : mapping of int to bytes
        Square PNG files by patch number.
    color_bar : bytes
        SVG file: what the colors mean.
    renderer : str
        What drew them: ``pyvista`` or ``software``.
    note : str
        A sentence for the user if it had to be another than usual, otherwise empty.
    """

    body: Mapping[str, bytes]
    closeups: Mapping[int, bytes]
    color_bar: bytes
    renderer: str
    note: str


def pictures(
    survey: "Survey",
    closeups: Sequence[int] = (),
    *,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> Pictures:
    """Draw a body from four sides with all its paths, and some of its patches from near.

    Parameters
    ----------
    survey : Survey
    closeups : sequence of int
        Numbers of the patches to draw from near.
    renderer : str, optional
        ``pyvista`` or ``software``; see `choose_renderer` for what is taken by default.
    advance : callable, optional
        Called after each picture with its name.

    Raises
    ------
    InputError
        If there is no such renderer or patch.
    MissingExtraError
        If matplotlib is not installed.
    """
    atlas = survey.atlas
    for patch in closeups:
        if not 0 <= patch < len(atlas):
            raise InputError(
                f"there is no patch {patch} to draw; the patches are numbered 0 to {len(atlas) - 1}"
            )
    choice = choose_renderer(renderer)
    render = RENDERERS[choice.renderer]
    scene = body_scene(survey)
    scale = ColorScale.of(scene.paths)

    body, near = {}, {}
    for side, view in body_views(scene, atlas.axes).items():
        body[side] = png(render(scene, view, view.size(BODY_PIXELS), scale, BODY_STYLE))
        if advance is not None:
            advance(side)
    for patch in closeups:
        part = patch_scene(survey, patch)
        view = patch_view(part, atlas.axes)
        part = cut_away(part, view)
        image = render(part, view, view.size(CLOSEUP_PIXELS), scale, CLOSEUP_STYLE)
        near[patch] = png(annotated(image, part, view, atlas.unit))
        if advance is not None:
            advance(f"patch {patch}")
    return Pictures(body, near, color_bar(scene.paths), choice.renderer, choice.note)


def png(image: NDArray[np.uint8]) -> bytes:
    """A picture, shape (height, width, 3), as a PNG file."""
    try:
        from PIL import Image
    except ImportError:
        raise MissingExtraError("a picture", "matplotlib", "report") from None
    file = io.BytesIO()
    Image.fromarray(image).save(file, format="PNG", compress_level=COMPRESSION)
    return file.getvalue()
