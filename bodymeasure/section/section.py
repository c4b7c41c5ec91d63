"""The exact section of an atlas by a plane."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, EdgeTable
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.bezier import project
from bodymeasure.errors import InputError
from bodymeasure.section.arcs import Arcs, Chain, chain_arcs, pair_crossings
from bodymeasure.section.cells import Cells, graph_cells
from bodymeasure.section.crossings import find_crossings
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.pieces import CutSurface, measured_pieces
from bodymeasure.section.plane import Plane
from bodymeasure.section.sensitivity import length_per_move
from bodymeasure.section.through.poles import joined_at_poles, opened, poles_in, turned_about

# Rounding decides on which side of the plane a corner within this part of the atlas's size lies.
NEAR = 1e-14
# Parts of the size by which the plane is moved off corners, and off seams that lie in it. They are
# far above rounding and far below what can be measured, and uneven, so that the accident of one
# move is not that of the next.
MOVES = (0.0, 1.0e-11, -1.0e-11, 2.7e-11, -3.1e-11)
# Patches whose control points are all within this part of the size from the plane lie in it.
FLAT = 1e-12
# Lengths change by about as much as the plane moves; the factor is for slanting surfaces.
SAFETY = 10.0
# Curves shorter than this part of the size may run round a cap that the plane hardly cuts off.
# Their lengths change much faster than the plane moves, and rounding moves it by so much, in parts
# of the size.
SMALL, DISTANCE_ROUNDING = 1e-2, 1e-15
# Curves shorter than this multiple of the move come from the move alone.
TRACE = 100.0
# Closed curves that enclose less than this part of the size, times their length, run there and
# back: the plane only touches the surface along a ridge.
SLIT = 1e-9


@dataclass(frozen=True, eq=False)
class PlaneSection:
    """All curves in which a plane cuts an atlas.

    Parameters
    ----------
    plane : Plane
        The plane that was asked for.
    loops : tuple of SectionLoop
        The longest comes first; empty if the plane misses the atlas.
    """

    plane: Plane
    loops: tuple[SectionLoop, ...]

    def nearest(self, position: ArrayLike) -> SectionLoop:
        """Return the loop that passes closest to a position.

        Raises
        ------
        InputError
            If the plane misses the atlas.
        """
        if not self.loops:
            raise InputError(
                f"{self.plane} misses the body; move it to where the body is, "
                "or check the atlas's unit and axes"
            )
        target = np.asarray(position, dtype=np.float64)
        gaps = [np.linalg.norm(loop.positions - target, axis=1).min() for loop in self.loops]
        return self.loops[int(np.argmin(gaps))]


def plane_section(atlas: Atlas, plane: Plane) -> PlaneSection:
    """Cut the smooth atlas by a plane.

    Parameters
    ----------
    atlas : Atlas
    plane : Plane

    Returns
    -------
    PlaneSection
        Curves are joined where patches share edges by index, and end elsewhere.

    Raises
    ------
    InputError
        If a patch lies in the plane, the plane touches the surface without a clean cut, or more
        than two patches share an edge that it crosses. A plane that touches a ridge in a point or
        along a line misses the atlas there.

    Notes
    -----
    Where corners of patches or whole seams lie in the plane, it is moved by 1e-11 of the atlas's
    size, or turned about a collapsed side through which it leads, and the loops' error estimates
    say so.
    """
    require_atlas(atlas)
    if not isinstance(plane, Plane):
        raise InputError(f"the plane is {plane!r}; expected a Plane, of a point and a normal")
    nets = _of_weight_one(atlas.control_points)
    approximation = atlas.approximation
    stretch = None if approximation is None else approximation.stretch
    surface = CutSurface(nets, plane, np.zeros((len(nets), 4), dtype=np.bool_), stretch)
    size = float(np.abs(project(nets) - plane.point).max())
    low, high = _bounds(surface)
    flat = np.flatnonzero(np.maximum(-low, high) <= FLAT * size)
    if len(flat):
        raise InputError(
            f"patch {atlas.patch_names[flat[0]]!r} lies in {plane}, so that the section is no "
            "curve; move or tilt the plane"
        )
    table = edges_of(atlas)
    poles = poles_in(atlas.points, table, plane, size)
    table, pole = opened(table, poles.sides)
    missed = False
    for move in MOVES:
        # A plane through poles is turned about them.
        if len(poles.points) or move != 0.0:
            turned = len(poles.points) > 0
            here = turned_about(plane, poles.points, move) if turned else plane.moved(move * size)
            surface = CutSurface(nets, here, poles.sides, stretch)
            low, high = _bounds(surface)
        # Patches beside the plane do not belong to the section, but share edges with those that do.
        near = np.flatnonzero((low <= 0.0) & (high >= 0.0))
        joined = _joined(atlas, surface.distances(near), near, (table, pole), size)
        if joined is None:
            continue
        moved = abs(move) * size
        loops = [
            loop
            for loop, area in _loops(atlas, surface, joined, size, moved + poles.away)
            # Corners that the plane only touched leave a trace when it is moved.
            if loop.length > TRACE * moved and not _is_slit(loop, area, size)
        ]
        if not loops and move != 0.0:
            # A boundary that lies in the plane is cut by the planes on one side of it only.
            missed = True
            continue
        return PlaneSection(plane, tuple(sorted(loops, key=lambda loop: -loop.length)))
    if missed:
        return PlaneSection(plane, ())
    raise InputError(
        f"the section by {plane} cannot be joined into curves: it runs through corners of patches "
        "wherever it is moved, or an edge belongs to more than two patches; check the atlas with "
        "bodymeasure.check_atlas, or move the plane"
    )


def _of_weight_one(nets: Array) -> Array:
    """Return the patches; the weights of rational ones are scaled to at most 1."""
    if nets.shape[-1] == 3:
        return nets
    return np.asarray(nets / nets[..., 3].max())


def _bounds(surface: CutSurface) -> tuple[Array, Array]:
    """Return the least and greatest coefficients of each patch's distances, shape (patches,)."""
    distances = surface.patches.distances.reshape(len(surface.control_points), -1)
    return distances.min(axis=1), distances.max(axis=1)


def _joined(
    atlas: Atlas,
    distance: Array,
    patches: Ints,
    edges: tuple[EdgeTable, Ints],
    size: float,
) -> tuple[Arcs, list[Chain]] | None:
    """Arcs and how they follow one another; None if the plane passes a corner too closely."""
    cells, undecided = graph_cells(distance, size)
    if len(undecided.patch):
        _refuse_touching(atlas, undecided, patches)
    if len(cells.patch) and np.abs(cells.corners).min() <= NEAR * size:
        return None
    table, pole = edges
    edge, number = np.unique(table.edge[patches], return_inverse=True)
    own = EdgeTable(
        table.control_index[patches],
        number.reshape(len(patches), 4),
        table.reversed[patches],
        table.sides[edge],
    )
    crossings = joined_at_poles(find_crossings(distance, cells, own), pole[edge])
    arcs = pair_crossings(cells, crossings)
    chains = None if arcs is None else chain_arcs(arcs, crossings.sides)
    if arcs is None or chains is None:
        return None
    own_pieces = replace(arcs.pieces, patch=patches[arcs.pieces.patch])
    return arcs._replace(pieces=own_pieces), chains


def _refuse_touching(atlas: Atlas, undecided: Cells, patches: Ints) -> None:
    patch = int(patches[undecided.patch[0]])
    u, v = 0.5 * (undecided.lower[0] + undecided.upper[0])
    raise InputError(
        f"the plane touches the surface of patch {atlas.patch_names[patch]!r} at "
        f"(u, v) = ({u:.6f}, {v:.6f}) instead of cutting it, so that the section is no clean "
        "curve there; move the plane a little"
    )


def _loops(
    atlas: Atlas,
    surface: CutSurface,
    joined: tuple[Arcs, list[Chain]],
    size: float,
    moved: float,
) -> Iterator[tuple[SectionLoop, float]]:
    """Yield the curves of chains, and twice the areas that they enclose if they are closed."""
    arcs, chains = joined
    if not chains:
        return
    backwards = np.concatenate([chain.backwards for chain in chains]).astype(np.float64)
    arc = np.concatenate([chain.arc for chain in chains])
    # All are measured together.
    pieces, (length, error, swept), origin = measured_pieces(
        surface, arcs.pieces.take(arc).between(backwards, 1.0 - backwards), size
    )
    ends = np.searchsorted(origin, np.cumsum([len(chain.arc) for chain in chains]))
    for chain, first, last in zip(chains, [0, *ends.tolist()], ends.tolist(), strict=False):
        rounding = np.finfo(np.float64).eps * size * (last - first)
        loop = SectionLoop(
            surface,
            pieces.take(slice(first, last)),
            length[first:last],
            float(error[first:last].sum() + rounding + SAFETY * moved),
            chain.closed,
            atlas.unit,
            atlas.regions,
        )
        if moved > 0.0 or loop.length < SMALL * size:
            shift = moved + DISTANCE_ROUNDING * size
            error_of_shift = length_per_move(loop) * shift
            loop = replace(loop, error_estimate=loop.error_estimate + error_of_shift)
        yield loop, abs(float(swept[first:last].sum()))


def _is_slit(loop: SectionLoop, area: float, size: float) -> bool:
    """Return whether a closed curve runs there and back, so that it encloses nothing."""
    return loop.closed and 0.5 * area <= SLIT * size * loop.length
