"""Derivatives of tapes in vertical planes that end at a level."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured
from bodymeasure.chart.kinds.surface.drop import DropMeasure
from bodymeasure.chart.kinds.surface.over import SAMPLES as OVER_SAMPLES
from bodymeasure.chart.kinds.surface.over import OverMeasure, profile_of, taut_corners
from bodymeasure.make.gradient.chain import COARSE, FINE, Nodes, bends, chain_weights
from bodymeasure.make.gradient.girths import NO_SPANS
from bodymeasure.make.gradient.planes import pull_level
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.sections import nodes_along, pull_in_plane
from bodymeasure.measure import vertical_drop
from bodymeasure.section import SectionLoop


def pull_drop(pull: Pull, body: Body, found: Measured, definition: DropMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a tape in a vertical plane."""
    start, level = body.point(definition.start), body.point(definition.level)
    drop = vertical_drop(body.atlas, start, level, plane=definition.plane)
    spans = drop.hull.spans if definition.tape == "taut" else NO_SPANS
    # The way back from the end to the start is a span of the hull, too.
    spans = spans[spans[:, 0] < spans[:, 1]]
    nodes, _ = nodes_along(drop.arc, 0.0, float(drop.arc.count), spans)
    _pull_ended(pull, body, drop.arc, nodes, chain_weights(nodes), definition)


def pull_over(pull: Pull, body: Body, found: Measured, definition: OverMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a tape in a vertical plane that passes over another one."""
    profile = profile_of(body, definition)
    for count, factor in ((OVER_SAMPLES, FINE), (OVER_SAMPLES // 2, COARSE)):
        corners, places = taut_corners(profile, count)
        weights = factor * bends(corners)
        free = np.flatnonzero(np.isnan(places))
        for node in free.tolist():
            # The middle between both landmarks stays in the tape's plane.
            left = body.atlas.axes.left_vector
            vector = weights[node] - (weights[node] @ left) * left
            for name in definition.over:
                pull.at(name, 0.5 * vector)
        on_skin = np.isfinite(places)
        patch, parameters = profile.arc.surface_points_at(places[on_skin])
        nodes = Nodes(patch, parameters, corners[on_skin], np.ones(len(patch), dtype=np.bool_))
        _pull_ended(pull, body, profile.arc, nodes, weights[on_skin], definition)


def _pull_ended(
    pull: Pull,
    body: Body,
    arc: SectionLoop,
    nodes: Nodes,
    weights: Array,
    definition: DropMeasure | OverMeasure,
) -> None:
    """Add the derivatives of a tape that starts at a landmark and ends at another's level."""
    up, weights = body.atlas.axes.up_vector, weights.copy()
    pull.at(definition.start, weights[0])
    # The end slides along the tape's curve until it is at the level.
    tangent = arc.motion(np.array([arc.count - 1]), np.array([[1.0]]))[1][0, 0]
    slide = float(weights[-1] @ tangent) / float(tangent @ up)
    pull.at(definition.level, slide * up)
    weights[-1] -= slide * up
    inner = Nodes(nodes.patch[1:], nodes.parameters[1:], nodes.positions[1:], nodes.coarse[1:])
    moved = pull_in_plane(pull, inner, weights[1:], arc.plane)
    pull_level(pull, moved, arc.plane.normal, definition.start)
