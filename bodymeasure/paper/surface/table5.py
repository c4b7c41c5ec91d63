"""Table 5: lengths on an atlas against those on the virtual model of a mannequin.

The paper measured "the virtual model of a real mannequin". Here that is the surface to which the
atlas was fitted, which is the Catmull-Clark limit of a quad mesh. The lengths on it are libigl's
exact geodesics, extrapolated over levels of subdivision; they share no code with the solver.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit, convert_length
from bodymeasure.errors import InputError
from bodymeasure.geodesic import Method
from bodymeasure.oracle.libigl import require_libigl
from bodymeasure.paper.data import published
from bodymeasure.paper.surface.curves import AtlasCurves, boundary_curves, diagonal_curves
from bodymeasure.paper.surface.fine_surface import (
    LEVELS,
    QUICK_LEVELS,
    FineSurface,
    closest_limit_points,
    fine_surface,
)
from bodymeasure.paper.surface.laid import LaidCurves, lay_curves
from bodymeasure.paper.surface.physical import PhysicalLengths, physical_lengths
from bodymeasure.paper.surface.source_mesh import load_source_mesh
from bodymeasure.paper.surface.surface_comparison import Comparison, Distribution, Row, distribution
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import QuadMesh

# The largest distance of an atlas from its surface, as a part of its curves. It is a hundredth at
# worst; a tenth means that they have different units or places.
FARTHEST = 0.1


@dataclass(frozen=True, eq=False)
class Table5:
    """Calculated and physical lengths, as in the paper's section 6.3 and Table 5.

    Parameters
    ----------
    diagonals, boundary : Comparison
        A boundary curve that two patches share is there once, on the patch with the lower number.
    """

    diagonals: Comparison
    boundary: Comparison

    def distributions(self) -> tuple[Distribution, Distribution]:
        """Return the spreads of the errors of the diagonals and of the boundary curves."""
        return distribution(self.diagonals), distribution(self.boundary)

    def in_the_papers_form(self) -> tuple[tuple[published.Table5Row, Row], ...]:
        """Return four rows, each with the published one for which it was chosen.

        For each published row, the diagonal with the nearest physical length is taken that no row
        before has taken, whatever its error. There are fewer rows without four lengths.
        """
        lengths = convert_length(self.diagonals.physical, self.diagonals.unit, Unit.CM)
        lengths = np.where(np.isfinite(self.diagonals.relative_error), lengths, np.inf)
        rows = []
        for printed in published.TABLE_5:
            nearest = int(np.argmin(np.abs(lengths - printed.physical)))
            if np.isfinite(lengths[nearest]):
                rows.append((printed, self.diagonals.row(nearest)))
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
    """Return Table 5 for a sample mannequin.

    Parameters
    ----------
    name : str
        A sample that was fitted to a quad mesh, such as ``female_average``.
    rows : int, optional
        For a quick run, the number of diagonals and boundary curves, which are chosen at random
        and measured on coarser meshes. All by default.
    seed : int
        Seed of that choice.
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
    """Return diagonals and boundary curves of an atlas against the surface to which it was fitted.

    Parameters
    ----------
    atlas : Atlas
    mesh : QuadMesh
        The control mesh of that surface, in the atlas's unit.
    method : Method, optional
        Method for the diagonals; `RBFCollocation()` by default.
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
    curves = _chosen(diagonal_curves(atlas, method), rows, generator)
    sides = _chosen(boundary_curves(atlas), rows, generator)
    ends, laid = _on_surface(surface, curves)
    physical = physical_lengths(surface, laid.points, ends, processes=processes, progress=progress)
    side_ends, laid_sides = _on_surface(surface, sides)
    lengths = PhysicalLengths(laid_sides.length, laid_sides.uncertainty)
    return Table5(
        _comparison(atlas, curves, ends, laid, physical),
        _comparison(atlas, sides, side_ends, laid_sides, lengths),
    )


def _on_surface(surface: FineSurface, curves: AtlasCurves) -> tuple[Array, LaidCurves]:
    """Return points of the surface closest to curves' ends (k, 2, 3), and the curves laid on it."""
    ends = _closest_ends(surface, curves.points)
    return ends, lay_curves(surface, curves.points, ends, curves.length)


def _comparison(
    atlas: Atlas,
    curves: AtlasCurves,
    ends: Array,
    laid: LaidCurves,
    physical: PhysicalLengths,
) -> Comparison:
    return Comparison(
        unit=atlas.unit,
        patch=curves.patch,
        place=curves.place,
        calculated=curves.length,
        physical=physical.length,
        uncertainty=physical.uncertainty,
        laid=laid.length,
        laid_uncertainty=laid.uncertainty,
        distance=laid.distance,
        offset=laid.offset,
        end_distance=np.linalg.norm(ends - curves.points[:, [0, -1]], axis=-1).max(axis=-1),
        bend=laid.bend,
        own_bend=laid.own_bend,
        status=curves.status,
    )


def _closest_ends(surface: FineSurface, curves: Array) -> Array:
    """Return points of the surface closest to curves' ends, shape (k, 2, 3).

    Raises
    ------
    InputError
        If the curves do not lie on the surface.
    """
    ends = curves[:, [0, -1]]
    # Most corners belong to several curves.
    corners, place = np.unique(ends.reshape(-1, 3), axis=0, return_inverse=True)
    points = closest_limit_points(surface, corners)[place.reshape(-1)].reshape(ends.shape)
    distance = np.linalg.norm(points - ends, axis=-1).max()
    chord = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1).mean()
    if distance > FARTHEST * chord:
        raise InputError(
            f"the atlas lies up to {distance:.3g} off the mesh's limit surface, with curves of "
            f"{chord:.3g} on average; give the mesh to which it was fitted, in the same unit and "
            "place"
        )
    return points


def _chosen(curves: AtlasCurves, rows: int | None, generator: np.random.Generator) -> AtlasCurves:
    """Return all curves, or so many chosen at random, in order."""
    if rows is None or rows >= len(curves):
        return curves
    return curves.take(np.sort(generator.choice(len(curves), rows, replace=False)))
