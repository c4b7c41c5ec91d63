"""What the shape of a fitted body tells besides: landmarks by rule, head, hands and feet."""

from collections.abc import Collection
from dataclasses import replace

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.chart import found_landmarks
from bodymeasure.extremities import extremity_lengths
from bodymeasure.fit.model import body_model


def completed(
    atlas: Atlas,
    vertices: Array,
    *,
    picked: Collection[str] = (),
    distance: Array | None = None,
) -> Atlas:
    """Return the atlas of a body with landmarks by rule and with lengths of head, hands and feet.

    Parameters
    ----------
    atlas : Atlas
        In meters, with carried and picked landmarks.
    vertices : ndarray, shape (13380, 3)
        Control vertices of the body's quad mesh, of which the atlas is made.
    picked : collection of str
        Landmarks that stay where they are.
    distance : ndarray, shape (13380,), optional
        Distances of the vertices' limits from the scan, NaN where it shows nothing; without it, the
        body is taken for the person.
    """
    given = extremity_lengths(vertices, body_model().quads, distance=distance)
    return replace(found_landmarks(atlas, keep=picked).atlas, given=given)
