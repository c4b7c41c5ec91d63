"""Outermost points of horizontal sections."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.landmarks.choice import TIE, direction_vector, preferred
from bodymeasure.chart.landmarks.rules.base import Facing
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.measure.body.merging import refuse_merged
from bodymeasure.section import Plane, SectionLoop, plane_section
from bodymeasure.section.places import LoopPlaces, local_maxima, point_of_place


def outermost(atlas: Atlas, at: Array, facing: Facing) -> AtlasPoint:
    """Return the outermost point of the horizontal loop that is nearest to a position.

    Raises
    ------
    InputError
        If the plane has no clean section, the curve is open where it is outermost, or it merges
        trunk and arm and its side is asked for.
    """
    section = plane_section(atlas, Plane(at, atlas.axes.up_vector))
    loop = section.nearest(at)
    if facing in ("left", "right"):
        # An arm beside the trunk does no harm in front and behind.
        refuse_merged(section, loop, limb=False)
    direction = direction_vector(atlas, facing)
    places = local_maxima(loop, direction)
    coordinate = places.position @ direction
    tie = TIE * extent(atlas)
    best = np.flatnonzero(coordinate >= coordinate.max() - tie)
    if not loop.closed and any(_is_end(loop, places, int(k)) for k in best):
        raise InputError(
            f"the section at that height ends on the boundary of the atlas, just where it reaches "
            f"farthest to the {facing}; the body may reach farther"
        )
    # If two are mirror images, the one on the landmark's own side is taken.
    apart = np.linalg.norm(places.position[best] - at, axis=1)
    best = best[apart <= apart.min() + tie]
    return preferred(atlas, [point_of_place(loop, places, int(k)) for k in best])


def _is_end(loop: SectionLoop, places: LoopPlaces, number: int) -> bool:
    place = places.piece[number] + places.fraction[number]
    return bool(place == 0.0 or place == len(loop.pieces))
