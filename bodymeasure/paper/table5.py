"""Table 5: lengths on an atlas against those on the virtual model of a mannequin.

The paper measured "the virtual model of a real mannequin"; here that is the surface to which the
atlas was fitted, the Catmull-Clark limit of a quad mesh, and the lengths on it are libigl's exact
geodesics, extrapolated over levels of subdivision. They share no code with the solver.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import EDGES, Atlas, Unit, convert_length, edge_table
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.geodesic import Method
from bodymeasure.measure import boundary_lengths, diagonals
from bodymeasure.oracle.libigl import require_libigl
from bodymeasure.paper.comparison import Comparison, Distribution, Row, distribution
from bodymeasure.paper.fine_surface import (
    LEVELS,
    QUICK_LEVELS,
    FineSurface,
    closest_limit_points,
    fine_surface,
)
from bodymeasure.paper.laid import lay_curves
from bodymeasure.paper.physical import physical_lengths
from bodymeasure.paper.source_mesh import load_source_mesh
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import QuadMesh

_Array = NDArray[np.float64]

# Points of a curve at which it is laid on the surface: 1.4 mm apart on a mannequin's diagonals.
POINTS = 65
# An atlas is off its surface by a part in a hundred of its patches at worst. A tenth means that
# they are in different units or places.
FARTHEST = 0.1


@dataclass(frozen=True)
class PublishedRow:
    """A row of the published table: lengths in cm, the error in percent as it is printed."""

    calculated: float
    physical: float
    relative_error: float


PUBLISHED = (
    PublishedRow(13.1038, 13.0, -0.8),
    PublishedRow(6.18354, 6.25, 1.06),
    PublishedRow(10.2788, 10.25, -0.28),
    PublishedRow(8.84254, 8.75, 1.06),
)


@dataclass(frozen=True, eq=False)
class Table5:
    """Calculated against physical lengths, as the paper's section 6.3 and Table 5 have them.

    Parameters
    ----------
    diagonals, boundary : Comparison
        Boundary curves that two patches share are there once, on the patch with the lower number.
    """

    diagonals: Comparison
    boundary: Comparison

    def distributions(self) -> tuple[Distribution, Distribution]:
        """The spread of the diagonals' errors, and of the boundary curves'."""
        return distribution(self.diagonals), distribution(self.boundary)

    def in_the_papers_form(self) -> tuple[tuple[PublishedRow, Row], ...]:
        """Four rows, each beside the published one that it was chosen for.

        For each published row, the diagonal with the physical length nearest to it that no row
        before has taken: by size alone, whatever its error. Fewer if there are not four lengths.
        """
        lengths = convert_length(self.diagonals.physical, self.diagonals.unit, Unit.CM)
        lengths = np.where(np.isfinite(self.diagonals.relative_error), lengths, np.inf)
        rows = []
        for published in PUBLISHED:
            nearest = int(np.argmin(np.abs(lengths - published.physical)))
            if np.isfinite(lengths[nearest]):
                rows.append((published, self.diagonals.row(nearest)))
            lengths[nearest] = np.inf
        return tuple(rows)


def table5(
    name: str,
    *,
    rows: int | None = None,
    seed: int = 0,
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> Table5:
    """Table 5 for a sample mannequin.

    Parameters
    ----------
    name : str
        A sample that was fitted to a quad mesh, such as ``female_average``.
    rows : int, optional
        For a quick look: so many diagonals and boundary curves, chosen at random, on coarser
        meshes. All by default.
    seed : int
        Of that choice.
    processes : int
        Worker processes.
    progress : callable, optional
        Called with the number of diagonals measured on the surface so far.

    Raises
    ------
    InputError
        If there is no such sample, or it was not fitted to a mesh.
    MissingExtraError
        If libigl is not installed.
    """
    mesh, _ = load_source_mesh(name)
    return compare_with_surface(
        load_sample(name), mesh, rows=rows, seed=seed, processes=processes, progress=progress
    )


def compare_with_surface(
    atlas: Atlas,
    mesh: QuadMesh,
    *,
    method: Method | None = None,
    rows: int | None = None,
    seed: int = 0,
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> Table5:
    """An atlas's diagonals and boundary curves against the surface that it was fitted to.

    Parameters
    ----------
    atlas : Atlas
    mesh : QuadMesh
        The control mesh of that surface, in the atlas's unit.
    method : Method, optional
        What the diagonals are calculated with; `RBFCollocation()` by default.
    rows, seed, processes, progress
        See `table5`.

    Raises
    ------
    InputError
        If the atlas does not lie on the surface.
    MissingExtraError
        If libigl is not installed.
    """
    if rows is not None and rows < 1:
        raise InputError(f"rows is {rows}; expected at least 1, or None for all")
    require_libigl()
    surface = fine_surface(mesh, LEVELS if rows is None else QUICK_LEVELS)
    generator = np.random.default_rng(seed)
    boundary = _boundary(atlas, surface, rows, generator)
    return Table5(
        _diagonals(atlas, surface, method, rows, generator, processes, progress), boundary
    )


def _diagonals(
    atlas: Atlas,
    surface: FineSurface,
    method: Method | None,
    rows: int | None,
    generator: np.random.Generator,
    processes: int,
    progress: Callable[[int], None] | None,
) -> Comparison:
    solution = diagonals(atlas, method=method)
    chosen = _choice(2 * len(atlas), rows, generator)
    patch, number = np.divmod(chosen, 2)
    lengths = solution.length.ravel()[chosen]
    t = np.linspace(0.0, 1.0, POINTS)
    start, end = (each.reshape(-1, 1, 2)[chosen] for each in (solution.start, solution.end))
    # Paths without a length may run anywhere; the straight line stands for them.
    straight = start + (end - start) * t[:, None]
    solved = solution.path(t).reshape(-1, POINTS, 2)[chosen]
    parameters = np.where(np.isfinite(lengths)[:, None, None], solved, straight)
    curves = evaluate(atlas.control_points[patch], parameters)
    ends, end_distance = _closest_ends(surface, curves)
    laid = lay_curves(surface, curves, ends, lengths)
    physical = physical_lengths(surface, laid.points, ends, processes=processes, progress=progress)
    return Comparison(
        unit=atlas.unit,
        patch=tuple(atlas.patch_names[i] for i in patch),
        place=tuple(f"diagonal {i + 1}" for i in number),
        calculated=lengths,
        physical=physical.length,
        uncertainty=physical.uncertainty,
        laid=laid.length,
        laid_uncertainty=laid.uncertainty,
        distance=laid.distance,
        offset=laid.offset,
        end_distance=end_distance,
        bend=laid.bend,
        own_bend=laid.own_bend,
        status=tuple(status.sentence for status in solution.status.ravel()[chosen]),
    )


def _boundary(
    atlas: Atlas, surface: FineSurface, rows: int | None, generator: np.random.Generator
) -> Comparison:
    _, first = np.unique(edge_table(atlas.index).edge.ravel(), return_index=True)
    chosen = np.sort(first)[_choice(len(first), rows, generator)]
    patch, side = np.divmod(chosen, 4)
    lengths = boundary_lengths(atlas).length.ravel()[chosen]
    parameters = np.empty((len(chosen), POINTS, 2))
    for row, edge in enumerate(EDGES[i] for i in side):
        parameters[row, :, edge.fixed_axis] = edge.fixed_value
        parameters[row, :, 1 - edge.fixed_axis] = np.linspace(0.0, 1.0, POINTS)
    curves = evaluate(atlas.control_points[patch], parameters)
    ends, end_distance = _closest_ends(surface, curves)
    laid = lay_curves(surface, curves, ends, lengths)
    return Comparison(
        unit=atlas.unit,
        patch=tuple(atlas.patch_names[i] for i in patch),
        place=tuple(f"side {EDGES[i].name}" for i in side),
        calculated=lengths,
        physical=laid.length,
        uncertainty=laid.uncertainty,
        laid=laid.length,
        laid_uncertainty=laid.uncertainty,
        distance=laid.distance,
        offset=laid.offset,
        end_distance=end_distance,
        bend=laid.bend,
        own_bend=laid.own_bend,
        status=("A side's length is an integral, with no equation to solve.",) * len(chosen),
    )


def _closest_ends(surface: FineSurface, curves: _Array) -> tuple[_Array, _Array]:
    """Points of the surface closest to curves' ends (k, 2, 3), and the farther end's distance.

    Raises
    ------
    InputError
        If the curves do not lie on the surface.
    """
    ends = curves[:, [0, -1]]
    # Most corners belong to several curves.
    corners, place = np.unique(ends.reshape(-1, 3), axis=0, return_inverse=True)
    points = closest_limit_points(surface, corners)[place.reshape(-1)].reshape(ends.shape)
    distance = np.linalg.norm(points - ends, axis=-1).max(axis=-1)
    chords = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
    if distance.max() > FARTHEST * chords.mean():
        raise InputError(
            f"the atlas lies up to {distance.max():.3g} off the mesh's limit surface, with curves "
            f"of {chords.mean():.3g} on average; give the mesh that it was fitted to, in the same "
            "unit and place"
        )
    return points, distance


def _choice(count: int, rows: int | None, generator: np.random.Generator) -> NDArray[np.int64]:
    """All numbers below `count`, or so many chosen at random, in order."""
    if rows is None or rows >= count:
        return np.arange(count)
    return np.sort(generator.choice(count, rows, replace=False))
