"""A panel on a body, cut out of the skin and laid flat."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic import geodesic_between
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.curves.skin_curve import SkinCurve
from bodymeasure.pattern.cutting.mesh import cut_mesh
from bodymeasure.pattern.cutting.region import Bound, Region, region_inside
from bodymeasure.pattern.definitions.panels import Dart, Panel
from bodymeasure.pattern.flat.cloth_line import length_on_cloth
from bodymeasure.pattern.flat.conformal import flat_conformally
from bodymeasure.pattern.flat.flatten import Flat, flattened
from bodymeasure.pattern.flat.level_line import LevelLine, level_line
from bodymeasure.pattern.flat.mesh import PieceMesh
from bodymeasure.pattern.flat.remesh import Outline, remeshed
from bodymeasure.pattern.flat.slit import slit
from bodymeasure.pattern.flat.triangles import side_lengths
from bodymeasure.pattern.hollows.bridged import bridged
from bodymeasure.pattern.pieces.edges import NEAREST_END, EdgeCurves, dart_curve
from bodymeasure.pattern.pieces.extended import extended
from bodymeasure.pattern.pieces.piece import (
    Piece,
    PieceDart,
    PieceEdge,
    dart_angle,
    outline_of,
)
from bodymeasure.section import Plane
from bodymeasure.wording import counted

# A piece whose cloth has to give more than this, in the root mean square, is worth a seam more.
MUCH_STRAIN = 0.10
# In meters: a level that is nowhere farther from an edge has the girth of that edge, as the waist
# of a bodice whose seam dips a little.
NEAR_EDGE = 0.025


class _Placed(NamedTuple):
    """A dart with its place on the panel."""

    dart: Dart
    edge: int
    arc: float
    curve: SkinCurve


def piece_of(curves: EdgeCurves, panel: Panel, step: float) -> Piece:
    """Return the flat piece of a panel.

    Parameters
    ----------
    curves : EdgeCurves
    panel : Panel
    step : float
        The length of the mesh's sides, in the atlas's unit.

    Raises
    ------
    InputError
        If the panel cannot be cut out or laid flat; the message names it, and the edge or dart.
    """
    try:
        return _piece_of(curves, panel, step)
    except (ConvergenceError, InputError) as error:
        raise InputError(f"panel {panel.name!r}: {error}") from error


def _piece_of(curves: EdgeCurves, panel: Panel, step: float) -> Piece:
    atlas = curves.atlas
    on_skin = [curves.of(edge) for edge in panel.edge]
    sides = [curves.on_cloth(edge) for edge in panel.edge]
    names = [edge.name for edge in panel.edge]
    numbers = [curves.key(edge) for edge in panel.edge]
    unique = list(dict.fromkeys(numbers))
    mesh = cut_mesh(atlas, [sides[numbers.index(key)] for key in unique])
    bounds = [
        Bound(edge.name, unique.index(key), *curves.ends(edge))
        for edge, key in zip(panel.edge, numbers, strict=True)
    ]
    region = region_inside(curves.cloth, mesh, _inside(curves, panel), bounds)
    # Either way round, as the panel's edges stand in its file.
    backwards = region.order[1] != 1
    border = np.concatenate([chain[:-1] for chain in region.border])
    sizes = side_lengths(region.positions, region.triangles)
    layout = flat_conformally(region.triangles, sizes, border)
    darts = [_placed(curves, panel, sides, dart) for dart in panel.dart]
    _refuse_crowded(darts, atlas.unit.meters)
    warnings: list[str] = []
    while True:
        flat = _laid_flat(curves, panel, (region, layout), sides, darts, step)
        shut = [
            (placed, angle, gap)
            for placed, (angle, gap) in zip(
                _in_order(darts, region, backwards), _openings(flat), strict=True
            )
            if angle <= 0.0
        ]
        if not shut:
            break
        for placed, _, gap in shut:
            overlap = 1000.0 * atlas.unit.meters * gap
            why = "the skin there is hollow and wants more cloth, not less"
            if len(darts) > len(shut):
                why += ", or another dart takes it up"
            warnings.append(
                f"dart {placed.dart.name!r} is left out: its legs would overlap by {overlap:.0f} "
                f"mm, since {why}"
            )
            darts.remove(placed)
    positions = _upright(flat, panel, region, atlas.axes.up_vector)
    if outward_sign(atlas) < 0.0:
        positions = positions * [-1.0, 1.0]
    edges = tuple(
        PieceEdge(
            names[number],
            panel.edge[number].seam,
            tuple(positions[chain.vertices] for chain in chains),
            on_skin[number].length,
            sum(chain.length for chain in chains),
            panel.edge[number].ease / atlas.unit.meters,
        )
        for number, chains in zip(region.order, flat.mesh.edges, strict=True)
    )
    cuts = tuple(
        PieceDart(
            placed.dart.name,
            placed.dart.edge,
            (positions[leg.before.vertices], positions[leg.after.vertices]),
            leg.before.length,
        )
        for placed, leg in zip(_in_order(darts, region, backwards), flat.mesh.darts, strict=True)
    )
    edges = extended(edges, panel, atlas.unit.meters)
    piece = Piece(panel, flat, positions, edges, cuts, outline_of(edges, cuts), ())
    warnings += _remarks(piece, atlas)
    return Piece(panel, flat, positions, edges, cuts, piece.outline, tuple(warnings))


def _inside(curves: EdgeCurves, panel: Panel) -> AtlasPoint:
    if isinstance(panel.inside, str):
        return curves.landmarks[panel.inside]
    start, end = (curves.landmarks[name] for name in panel.inside)
    patch, (u, v) = geodesic_between(curves.atlas, start, end).path(0.5)
    return AtlasPoint(int(patch), float(u), float(v))


def _placed(curves: EdgeCurves, panel: Panel, sides: list[SkinCurve], dart: Dart) -> _Placed:
    names = [edge.name for edge in panel.edge]
    number = names.index(dart.edge)
    target = sides[names.index(dart.towards)] if dart.towards else None
    try:
        arc, curve = dart_curve(curves, dart, sides[number], target)
    except (ConvergenceError, InputError) as error:
        raise InputError(f"dart {dart.name!r}: {error}") from error
    return _Placed(dart, number, arc, curve)


def _refuse_crowded(darts: list[_Placed], meters: float) -> None:
    for one, other in combinations(darts, 2):
        apart = abs(one.arc - other.arc) * meters
        if one.edge == other.edge and apart < NEAREST_END:
            raise InputError(
                f"the feet of darts {one.dart.name!r} and {other.dart.name!r} are "
                f"{1000.0 * apart:.1f} mm apart; let them begin {1000.0 * NEAREST_END:.0f} mm "
                "apart or more"
            )


def _in_order(darts: list[_Placed], region: Region, backwards: bool) -> list[_Placed]:
    """Return darts in the order in which they come counterclockwise."""
    sign = -1.0 if backwards else 1.0
    return sorted(darts, key=lambda placed: (region.order.index(placed.edge), sign * placed.arc))


def _laid_flat(
    curves: EdgeCurves,
    panel: Panel,
    cut: tuple[Region, Array],
    sides: list[SkinCurve],
    darts: list[_Placed],
    step: float,
) -> Flat:
    region, layout = cut
    backwards = region.order[1] != 1
    edges = tuple(sides[i].reversed if backwards else sides[i] for i in region.order)
    ordered = _in_order(darts, region, backwards)
    cuts = tuple(
        tuple(
            sides[number].length - placed.arc if backwards else placed.arc
            for placed in ordered
            if placed.edge == number
        )
        for number in region.order
    )
    outline = Outline(
        edges,
        cuts,
        tuple(placed.curve for placed in ordered),
        tuple(placed.dart.name for placed in ordered),
    )
    names = [edge.name for edge in panel.edge]
    fold = region.order.index(names.index(panel.fold)) if panel.fold else None
    even = remeshed(region, layout, outline, step)
    if curves.bridge:
        even = bridged(curves.cloth, even, fold)
    mesh = slit(curves.cloth, even)
    straight = tuple(placed.dart.legs == "straight" for placed in ordered)
    lines = tuple(_eased_lines(curves.cloth, (region, layout), mesh))
    return flattened(mesh, fold=fold, downwards=backwards, straight=straight, lines=lines)


def _eased_lines(cloth: Cloth, cut: tuple[Region, Array], mesh: PieceMesh) -> Iterator[LevelLine]:
    """Yield the lines at the levels that have ease, whose girths the garment is to have."""
    if cloth.ease is None:
        return
    axis, near = cloth.ease.axis, NEAR_EDGE / cloth.atlas.unit.meters
    skin = evaluate(cloth.atlas.control_points[mesh.places.patch], mesh.places.parameters)
    for level, girth in zip(cloth.ease.heights, cloth.ease.girths, strict=True):
        line = level_line(mesh, skin @ axis - level, near) if girth else None
        if line is not None:
            plane = Plane(level * axis, axis)
            yield replace(line, length=length_on_cloth(cloth, cut, mesh, line, plane))


def _openings(flat: Flat) -> list[tuple[float, float]]:
    """Return the angle of each dart in degrees, and the distance of its feet."""
    result = []
    for leg in flat.mesh.darts:
        before, after = (flat.positions[chain.vertices] for chain in (leg.before, leg.after))
        result.append((dart_angle(before, after), float(np.linalg.norm(before[0] - after[0]))))
    return result


def _upright(flat: Flat, panel: Panel, region: Region, upwards: Array) -> Array:
    """Return the piece with its grain up; a fold is upright already."""
    grain = panel.grain or panel.fold
    if not grain or grain == panel.fold:
        return flat.positions
    names = [edge.name for edge in panel.edge]
    number = region.order.index(names.index(grain))
    chains = flat.mesh.edges[number]
    ends = flat.positions[[chains[0].vertices[0], chains[-1].vertices[-1]]]
    up = ends[1] - ends[0]
    # Edges may be listed upwards or downwards; pieces are drawn as they are worn, top up.
    border = region.border[number]
    if (region.positions[border[-1]] - region.positions[border[0]]) @ upwards < 0.0:
        up = -up
    up = up / np.linalg.norm(up)
    return np.asarray((flat.positions - ends[0]) @ np.array([[up[1], up[0]], [-up[0], up[1]]]))


def _remarks(piece: Piece, atlas: Atlas) -> list[str]:
    result = []
    if not piece.flat.converged:
        missed = 1000.0 * atlas.unit.meters * piece.flat.missed
        result.append(
            f"the piece has not settled: a side of its border is off by {missed:.1e} mm; cut the "
            "panel into two, or add a dart"
        )
    if piece.flips:
        result.append(f"{counted(piece.flips, 'triangle')} of the piece lie on their faces")
    if not piece.is_simple:
        remedy = "shorten its extension, let that flare more, " if piece.panel.extend else ""
        if any(edge.ease for edge in piece.edges):
            remedy += "ease less into its seams, "
        result.append(f"the outline crosses itself; {remedy}cut the panel into two, or add a dart")
    if piece.rms_strain > MUCH_STRAIN:
        result.append(
            f"the cloth has to give by {100.0 * piece.rms_strain:.1f} % in the root mean square; "
            "cut the panel into two, as a princess seam does, or add a dart"
        )
    return result
