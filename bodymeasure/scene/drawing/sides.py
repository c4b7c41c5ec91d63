"""Pictures of one body from several sides."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.drawing.picture import Picture
from bodymeasure.scene.figures.canvas import webp


@dataclass(frozen=True)
class SidePictures:
    """Pictures of a body by the side from which it is seen.

    Parameters
    ----------
    body : mapping of str to bytes
        WebP files by side: ``front``, the wearer's ``left`` and ``right``, and ``back``, those that
        were drawn; to be shown at half their size in pixels.
    renderer : str
        The renderer that drew them: ``pyvista`` or ``software``.
    note : str
        Why it was not the usual one, as a sentence; empty if it was.
    """

    body: Mapping[str, bytes]
    renderer: str
    note: str


def side_pictures(
    pictures: Iterable[tuple[str, Picture]],
    *,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> SidePictures:
    """Draw pictures by their sides.

    Parameters
    ----------
    pictures : iterable of (str, Picture)
        Each is made when it is drawn.
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.
    advance : callable, optional
        Called after each picture with its side.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    choice = choose_renderer(renderer)
    drawn = {}
    with RENDERERS[choice.renderer]() as draw:
        for side, picture in pictures:
            drawn[side] = webp(draw(picture))
            if advance is not None:
                advance(side)
    return SidePictures(drawn, choice.renderer, choice.note)
