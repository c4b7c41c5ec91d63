"""Derivatives of girths."""

import numpy as np

from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured
from bodymeasure.chart.kinds.girths.extreme_girth import ExtremeGirthMeasure
from bodymeasure.chart.kinds.girths.girth import GirthMeasure
from bodymeasure.chart.kinds.girths.limb_girth import LimbGirthMeasure
from bodymeasure.chart.kinds.girths.tilted_girth import TiltedGirthMeasure
from bodymeasure.make.gradient.planes import pull_level, pull_tilted, pull_turned
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.sections import InPlane, pull_tape, whole_tape
from bodymeasure.measure import Girth
from bodymeasure.measure.body.girths import girth_of_loop
from bodymeasure.section import Plane, plane_section

NO_SPANS = np.empty((0, 2))
# A girth is the most extreme one of a stretch inside it, if its plane is no nearer to an end than
# this part of the stretch.
AT_END = 1e-5


def pull_girth(pull: Pull, body: Body, found: Measured, definition: GirthMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a horizontal girth."""
    girth = body.level_girth(definition.at, cut=definition.cut, limb=definition.limb)
    moved = _pull_round(pull, girth, taut=definition.tape == "taut")
    pull_level(pull, moved, girth.loop.plane.normal, definition.at)


def pull_limb_girth(pull: Pull, body: Body, found: Measured, definition: LimbGirthMeasure) -> None:
    """Add the derivatives of a girth that is square to a limb."""
    first, last = body.position(definition.start), body.position(definition.end)
    at = definition.at
    foot = body.position(at) if isinstance(at, str) else first + at * (last - first)
    girth = _girth_in(body, Plane(foot, last - first), found)
    moved = _pull_round(pull, girth, taut=definition.tape == "taut")
    normal, ends = girth.loop.plane.normal, (definition.start, definition.end)
    pull_turned(pull, moved, ends, body, foot)
    shift = float(moved.rate.sum()) * normal
    if isinstance(at, str):
        pull.at(at, shift)
    else:
        pull.at(definition.start, (1.0 - at) * shift)
        pull.at(definition.end, at * shift)


def pull_tilted_girth(
    pull: Pull, body: Body, found: Measured, definition: TiltedGirthMeasure
) -> None:
    """Add the derivatives of a girth in a plane that leans."""
    axes = body.atlas.axes
    level = axes.front_vector if definition.plane == "median" else axes.left_vector
    first, second = map(body.position, definition.through)
    girth = _girth_in(body, Plane(first, np.cross(level, first - second)), found)
    moved = _pull_round(pull, girth, taut=definition.tape == "taut")
    pull_tilted(pull, moved, definition.through, body, level)


def pull_extreme_girth(
    pull: Pull, body: Body, found: Measured, definition: ExtremeGirthMeasure
) -> None:
    """Add the derivatives of the largest or smallest girth of a stretch.

    Inside the stretch its place makes no difference, since the girth is extreme there.
    """
    first, last = body.position(definition.start), body.position(definition.end)
    up = body.atlas.axes.up_vector
    normal = last - first if definition.limb else up
    foot = found.tape.points[0]
    girth = _girth_in(body, Plane(foot, normal), found)
    moved = _pull_round(pull, girth, taut=definition.tape != "contact")
    normal = girth.loop.plane.normal
    way = float((foot - first) @ normal / ((last - first) @ normal))
    if definition.limb:
        ends = (definition.start, definition.end)
        pull_turned(pull, moved, ends, body, first + way * (last - first))
    for name, place in ((definition.start, 0.0), (definition.end, 1.0)):
        if abs(way - place) < AT_END:
            pull_level(pull, moved, normal, name)


def _girth_in(body: Body, plane: Plane, found: Measured) -> Girth:
    """Return the girth in a plane that was measured already."""
    return girth_of_loop(plane_section(body.atlas, plane).nearest(found.tape.points[0]))


def _pull_round(pull: Pull, girth: Girth, *, taut: bool) -> InPlane:
    nodes = whole_tape(girth.tape, girth.hull.spans if taut else NO_SPANS)
    return pull_tape(pull, nodes, girth.loop.plane)
