"""Derivatives of the front or the back of a girth."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured
from bodymeasure.chart.kinds.girths.girth_arc import GirthArcMeasure
from bodymeasure.make.gradient.chain import Nodes, chain_weights
from bodymeasure.make.gradient.planes import pull_level
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.sections import nodes_along, pull_in_plane
from bodymeasure.measure.body.girth_arcs import arc_ends
from bodymeasure.section import Curve

NO_SPANS = np.empty((0, 2))
# The part of a piece over which the turn of a curve is taken, for ends beside their landmarks.
BESIDE = 1e-3
# An end is at its landmark if it is no farther away than this part of the girth.
AT_LANDMARK = 1e-9


def pull_girth_arc(pull: Pull, body: Body, found: Measured, definition: GirthArcMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of a part of a girth between the places nearest to two landmarks."""
    girth = body.level_girth(definition.at, cut=definition.cut)
    start, end = body.position(definition.start), body.position(definition.end)
    front = body.atlas.axes.front_vector
    first, last, _ = arc_ends(girth, start, end, front, definition.side)
    curve = girth.tape
    spans = girth.hull.spans if definition.tape == "taut" else NO_SPANS
    begin, stop = _span_at(spans, first), _span_at(spans, last)
    low = first if begin is None else float(begin[1])
    high = last if stop is None else float(stop[0])
    nodes, _ = nodes_along(curve, low, high if high > low else high + curve.count, spans)
    gathered = _Gathered(pull, definition, body, curve)
    weights = chain_weights(nodes)
    before, after = np.zeros(3), np.zeros(3)
    if begin is not None:
        # In a hollow, the arc ends on the straight part, square across from the place.
        weights[0] += gathered.hollow(begin, first, 1.0)
    else:
        before, weights[0] = weights[0].copy(), 0.0
        gathered.end(first, before)
    if stop is not None:
        weights[-1] += gathered.hollow(stop, last, -1.0)
    else:
        after, weights[-1] = weights[-1].copy(), 0.0
        gathered.end(last, after)
    gathered.nodes(nodes, weights)


class _Gathered:
    """The derivatives of an arc, node by node."""

    def __init__(self, pull: Pull, definition: GirthArcMeasure, body: Body, curve: Curve) -> None:
        self._pull, self._at, self._curve = pull, definition.at, curve
        self._names = (definition.start, definition.end)
        self._places = np.stack([body.position(name) for name in self._names])

    def nodes(self, nodes: Nodes, weights: Array) -> None:
        """Add the derivatives of nodes that stay where they are on the skin."""
        plane = self._curve.plane
        moved = pull_in_plane(self._pull, nodes, weights, plane)
        pull_level(self._pull, moved, plane.normal, self._at)

    def hollow(self, span: Array, place: float, sign: float) -> Array:
        """Add what an end in a hollow gives, and return the weight of the node where it begins.

        Parameters
        ----------
        span : ndarray, shape (2,)
            Places at which the straight part over the hollow starts and ends.
        place : float
            The place in the hollow.
        sign : float
            1 for the start of the arc, and -1 for its end.
        """
        one, other = self._curve.positions_at(span % self._curve.count)
        chord = other - one
        size = float(np.linalg.norm(chord))
        along = chord / size
        there = other if sign > 0.0 else one
        point = self._curve.positions_at(np.array([place]))[0]
        aside = there - point
        aside -= (aside @ along) * along
        # The part of the straight line is sign (there - point) . along.
        turn = sign * aside / size
        self.end(place, -sign * along)
        near, far = sign * along, np.zeros(3)
        if sign > 0.0:
            near, far = near + turn, far - turn
            self._node(float(span[0]), far)
            return np.asarray(near)
        near, far = near - turn, far + turn
        self._node(float(span[1]), far)
        return np.asarray(near)

    def end(self, place: float, weight: Array) -> None:
        """Add the derivatives of the place of the curve that is nearest to a landmark."""
        curve = self._curve
        row = min(int(place), curve.count - 1)
        at = min(max(place - row, BESIDE), 1.0 - BESIDE) + row
        three = np.array([at - BESIDE, at, at + BESIDE])
        points = curve.positions_at(three)
        velocity = curve.motion(np.array([row]), np.array([[place - row]]))[1][0, 0]
        tangent = velocity / np.linalg.norm(velocity)
        point = curve.positions_at(np.array([place]))[0]
        number = int(np.linalg.norm(self._places - point, axis=1).argmin())
        wanted = (
            self._places[number]
            - float(curve.plane.distances(self._places[number])) * curve.plane.normal
        )
        off = wanted - point
        step = 0.5 * float(np.linalg.norm(points[2] - points[0]))
        curved = (points[2] - 2.0 * points[1] + points[0]) / step**2
        slide = float(weight @ tangent) / (1.0 - float(off @ curved))
        self._pull.at(self._names[number], slide * tangent)
        self._node(place, weight - slide * tangent)
        if np.linalg.norm(off) > AT_LANDMARK * curve.length:
            turn = slide * off / (2.0 * step)
            self._node(float(three[2]), turn)
            self._node(float(three[0]), -turn)

    def _node(self, place: float, weight: Array) -> None:
        at = np.array([place % self._curve.count])
        patch, parameters = self._curve.surface_points_at(at)
        nodes = Nodes(patch, parameters, self._curve.positions_at(at), np.ones(1, dtype=np.bool_))
        self.nodes(nodes, weight[None])


def _span_at(spans: Array, place: float) -> Array | None:
    """Return the span inside which a place lies, if there is one."""
    for first, last in spans.tolist():
        inside = first < place < last if first < last else place > first or place < last
        if inside:
            return np.array([first, last])
    return None
