"""Curves of a panel's edges and darts on a body."""

from collections.abc import Mapping

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.curves.geodesics import geodesic_curve
from bodymeasure.pattern.curves.on_cloth import on_cloth, stretched
from bodymeasure.pattern.curves.sections import section_curve
from bodymeasure.pattern.curves.skin_curve import SkinCurve
from bodymeasure.pattern.curves.smooth import smooth_curve
from bodymeasure.pattern.definitions.panels import Dart, Edge
from bodymeasure.section import Plane

# Samples of an edge among which the place nearest to a dart's foot is sought, and the rounds in
# which each time the steps beside it are cut again.
SAMPLES, ROUNDS = 64, 6
# In meters: a foot farther from its edge is another place.
FARTHEST_FOOT = 0.03
# In meters: a foot nearer to the end of its edge leaves no cloth for the seam there, and one that
# is nearer to another foot leaves none between both darts.
NEAREST_END = 0.01
# The part of an edge that has to be left where its ease makes it shorter.
LEAST_PART = 0.5
# The shortest dart, in meters.
SHORTEST = 0.01


class EdgeCurves:
    """The curves of edges on a body, each of which is found once.

    Edges that name a seam, and edges through the same landmarks, are one curve.
    """

    def __init__(
        self, cloth: Cloth, landmarks: Mapping[str, AtlasPoint], *, bridge: bool = False
    ) -> None:
        self.cloth, self.atlas, self.landmarks = cloth, cloth.atlas, landmarks
        self.bridge = bridge
        self._known: dict[tuple[object, ...], SkinCurve] = {}
        self._on_cloth: dict[tuple[object, ...], SkinCurve] = {}

    @staticmethod
    def key(edge: Edge) -> tuple[object, ...]:
        """Return what two edges have in common that lie on one curve, either way."""
        through = min(edge.through, edge.through[::-1])
        return edge.kind, edge.plane, edge.via, through

    def ends(self, edge: Edge) -> tuple[Array, Array]:
        """Return where on the cloth an edge begins and ends."""
        points = [self.landmarks[edge.through[row]] for row in (0, -1)]
        patch = np.array([point.patch for point in points])
        start, end = self.cloth.positions(patch, np.array([[p.u, p.v] for p in points]))
        return start, end

    def on_cloth(self, edge: Edge) -> SkinCurve:
        """Return the curve of an edge on the cloth above the skin, found once as well.

        An edge that is eased into its seam is longer by that, evenly.

        Raises
        ------
        InputError
            If there is no such curve, or too little of it is left.
        """
        key = (edge.kind, edge.plane, edge.via)
        if (key, edge.through) not in self._on_cloth:
            curve = on_cloth(self.of(edge), self.cloth)
            self._on_cloth[key, edge.through] = curve
            self._on_cloth[key, edge.through[::-1]] = curve.reversed
        curve = self._on_cloth[key, edge.through]
        ease = edge.ease / self.atlas.unit.meters
        if not ease:
            return curve
        if curve.length + ease < LEAST_PART * curve.length:
            raise InputError(
                f"edge {edge.name!r}: its ease of {100.0 * edge.ease:.1f} cm leaves too little of "
                f"its {100.0 * curve.length * self.atlas.unit.meters:.1f} cm; choose a smaller one"
            )
        return stretched(curve, curve.length + ease)

    def of(self, edge: Edge) -> SkinCurve:
        """Return the curve of an edge on the skin.

        Raises
        ------
        InputError
            If there is no such curve; the message names the edge.
        """
        key = (edge.kind, edge.plane, edge.via)
        if (key, edge.through) not in self._known:
            try:
                curve = self._found(edge)
            except (ConvergenceError, InputError) as error:
                raise InputError(f"edge {edge.name!r}: {error}") from error
            self._known[key, edge.through] = curve
            self._known[key, edge.through[::-1]] = curve.reversed
        return self._known[key, edge.through]

    def _found(self, edge: Edge) -> SkinCurve:
        points = [self.landmarks[name] for name in edge.through]
        if edge.kind == "geodesic":
            return geodesic_curve(self.atlas, points)
        if edge.kind == "curve":
            return smooth_curve(self.atlas, points)
        via = self.landmarks[edge.via] if edge.via else None
        return section_curve(self.atlas, self._plane(edge), (points[0], points[-1]), via)

    def _plane(self, edge: Edge) -> Plane:
        atlas = self.atlas
        named = edge.plane if isinstance(edge.plane, tuple) else ()
        points = [atlas.position(self.landmarks[name]) for name in named]
        if len(points) == 3:
            return Plane(points[0], np.cross(points[1] - points[0], points[2] - points[0]))
        start, end = (atlas.position(self.landmarks[edge.through[i]]) for i in (0, -1))
        along = end - start
        if edge.plane == "front":
            return Plane(start, np.cross(along, atlas.axes.front_vector))
        if points:
            wanted = points[1] - points[0]
        else:
            wanted = atlas.axes.up_vector if edge.plane == "level" else atlas.axes.left_vector
        along = along / np.linalg.norm(along)
        return Plane(start, wanted - (wanted @ along) * along)


def place_of_foot(atlas: Atlas, curve: SkinCurve, foot: AtlasPoint) -> float:
    """Return the length along a curve at which it is nearest to a point.

    Raises
    ------
    InputError
        If the curve does not pass near it.
    """
    target = atlas.position(foot)
    center, width = 0.5 * curve.length, 0.5 * curve.length
    for _ in range(ROUNDS):
        arcs = np.clip(np.linspace(center - width, center + width, SAMPLES), 0.0, curve.length)
        away = np.linalg.norm(_positions(atlas, curve, arcs) - target, axis=1)
        center, width = float(arcs[away.argmin()]), 4.0 * width / SAMPLES
    gap = float(away.min()) * atlas.unit.meters
    if gap > FARTHEST_FOOT:
        raise InputError(
            f"its foot is {100.0 * gap:.1f} cm from the edge; choose a landmark on the edge, or "
            "give 'at'"
        )
    return center


def dart_curve(
    curves: EdgeCurves, dart: Dart, edge: SkinCurve, target: SkinCurve | None
) -> tuple[float, SkinCurve]:
    """Return the length along the edge at which a dart begins, and its curve to the tip.

    Parameters
    ----------
    curves : EdgeCurves
    dart : Dart
    edge : SkinCurve
        The edge on which it begins, on the cloth.
    target : SkinCurve, optional
        The edge towards whose middle it leads, if it does not lead to a landmark.
    """
    atlas, meters = curves.atlas, curves.atlas.unit.meters
    if dart.at is not None:
        arc = dart.at * edge.length
    else:
        arc = place_of_foot(atlas, edge, curves.landmarks[dart.foot])
    beside = min(arc, edge.length - arc) * meters
    if beside < NEAREST_END:
        raise InputError(
            f"its foot is {1000.0 * beside:.1f} mm from the end of edge {dart.edge!r}, where no "
            f"dart can be sewn; let it begin {1000.0 * NEAREST_END:.0f} mm away or more"
        )
    foot = point_at(edge, arc)
    end = curves.landmarks[dart.tip] if target is None else point_at(target, 0.5 * target.length)
    whole = on_cloth(geodesic_curve(atlas, [foot, end]), curves.cloth)
    length = whole.length - dart.short / meters
    if dart.length is not None:
        length = dart.length / meters
    if not SHORTEST / meters <= length <= whole.length:
        raise InputError(
            f"its length would be {100.0 * length * meters:.1f} cm, of "
            f"{100.0 * whole.length * meters:.1f} cm from its foot to where it leads; change "
            "'short' or 'length'"
        )
    turns = whole.turns[whole.turns < length]
    return arc, SkinCurve(length, (), whole.places, turns)


def point_at(curve: SkinCurve, arc: float) -> AtlasPoint:
    """Return the point of a curve at a length from its start."""
    patch, parameters = curve.places(np.array([arc]))
    return AtlasPoint(int(patch[0]), *parameters[0].clip(0.0, 1.0).tolist())


def _positions(atlas: Atlas, curve: SkinCurve, arcs: Array) -> Array:
    patch, parameters = curve.places(arcs)
    return evaluate(atlas.control_points[patch], parameters)
