"""The pictures of a fit."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.scene.drawing.sides import SidePictures
from bodymeasure.scene.fits.pictures import Triangles, fit_pictures

if TYPE_CHECKING:
    from bodymeasure.fit import FittedBody


def drawn(body: "FittedBody", advance: Callable[[str], None] | None = None) -> SidePictures:
    """Draw a fitted body over its scan from three sides.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    """
    surface, scan = meshes(body)
    return fit_pictures(surface, body.distance, scan, advance=advance)


def meshes(body: "FittedBody") -> tuple[Triangles, Triangles]:
    """Return a fitted body, head, hands and feet included, and its scan as triangles."""
    # A slow import, which a page without pictures does not need.
    from bodymeasure.fit.model import body_model, limit_matrix

    quads = body_model().quads
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    surface = Triangles(np.asarray(limit_matrix() @ body.vertices), triangles)
    return surface, Triangles(body.scan.vertices, body.scan.triangles)
