"""All pictures of a survey."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from bodymeasure.errors import InputError
from bodymeasure.scene.camera import SIDES, body_views, patch_view
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.diagonals.annotate import annotated
from bodymeasure.scene.diagonals.build import body_scene, patch_scene
from bodymeasure.scene.diagonals.strokes import BODY_STYLE, CLOSEUP_STYLE, scene_picture
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.figures.canvas import png
from bodymeasure.scene.figures.color_bar import color_bar

if TYPE_CHECKING:
    from bodymeasure.measure import Survey


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
        SVG file that explains the colors.
    renderer : str
        The renderer that drew them: ``pyvista`` or ``software``.
    note : str
        Why it was not the usual one, as a sentence; empty if it was.
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
    sides: Sequence[str] = SIDES,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> Pictures:
    """Draw a body from four sides with all its paths, and some of its patches from near.

    Parameters
    ----------
    survey : Survey
    closeups : sequence of int
        Numbers of the patches to draw from near.
    sides : sequence of str
        The sides from which the body is drawn.
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.
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
    advance = advance or (lambda _name: None)
    choice = choose_renderer(renderer)
    scene = body_scene(survey)
    scale = ColorScale.of(scene.paths)
    body, near = {}, {}
    with RENDERERS[choice.renderer]() as draw:
        views = body_views(scene, atlas.axes)
        for side in sides:
            view = views[side]
            body[side] = png(draw(scene_picture(scene, view, scale, BODY_STYLE)))
            advance(side)
        for patch in closeups:
            part = patch_scene(survey, patch)
            view = patch_view(part, atlas.axes)
            picture = scene_picture(part, view, scale, CLOSEUP_STYLE)
            near[patch] = png(draw(annotated(picture, part.labels, atlas.unit)))
            advance(f"patch {patch}")
    return Pictures(body, near, color_bar(scene.paths), choice.renderer, choice.note)
