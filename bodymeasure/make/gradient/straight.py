"""Derivatives of measurements along straight lines."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured
from bodymeasure.chart.kinds.straight.breadth import BreadthMeasure
from bodymeasure.chart.kinds.straight.chord import ChordMeasure
from bodymeasure.chart.kinds.straight.depth import DepthMeasure
from bodymeasure.chart.kinds.straight.height import HeightMeasure
from bodymeasure.make.gradient.chain import Nodes
from bodymeasure.make.gradient.planes import pull_level
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.sections import pull_in_plane
from bodymeasure.section.places import local_maxima


def pull_slopes(
    pull: Pull, body: Body, found: Measured, definition: HeightMeasure | ChordMeasure
) -> None:
    """Add the derivatives of what depends on landmarks alone."""
    for name, slope in definition.slopes(body, found, {}).items():
        pull.at(name, slope)


def pull_breadth(pull: Pull, body: Body, found: Measured, definition: BreadthMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a breadth."""
    _pull_extent(pull, body, definition.at, body.atlas.axes.left_vector)


def pull_depth(pull: Pull, body: Body, found: Measured, definition: DepthMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a depth."""
    _pull_extent(pull, body, definition.at, body.atlas.axes.front_vector)


def _pull_extent(pull: Pull, body: Body, at: str, direction: Array) -> None:
    loop = body.level_girth(at).loop
    for sign in (1.0, -1.0):
        places = local_maxima(loop, sign * direction)
        best = [int(np.argmax(places.position @ (sign * direction)))]
        nodes = Nodes(
            loop.pieces.patch[places.piece[best]],
            places.parameters[best],
            places.position[best],
            np.ones(1, dtype=np.bool_),
        )
        moved = pull_in_plane(pull, nodes, sign * direction[None], loop.plane)
        pull_level(pull, moved, loop.plane.normal, at)
