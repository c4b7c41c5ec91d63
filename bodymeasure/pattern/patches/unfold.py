"""The paper's Bijective Pattern Map: each patch of an atlas unfolded by itself."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Atlas
from bodymeasure.measure import boundary_lengths, diagonals
from bodymeasure.pattern.patches.six_lengths import flat_quadrilaterals, lengths_of, turned_over
from bodymeasure.threads import one_blas_thread


@dataclass(frozen=True, eq=False)
class UnfoldedPatches:
    """The patches of an atlas as quadrilaterals in the plane.

    Parameters
    ----------
    atlas : Atlas
    corners : ndarray, shape (patches, 4, 2)
        The corners (u, v) = (0, 0), (1, 0), (1, 1) and (0, 1), in the atlas's unit and
        counterclockwise; the first is the origin, and the second lies on the first axis.
    lengths : ndarray, shape (patches, 6)
        On the body: the sides v = 0, u = 1, v = 1 and u = 0, and the diagonals from (0, 0) and from
        (1, 0), in the atlas's unit.
    """

    atlas: Atlas
    corners: Array
    lengths: Array

    @property
    def misfit(self) -> Array:
        """The six lengths in the plane less those on the body, shape (patches, 6)."""
        return lengths_of(self.corners) - self.lengths

    @property
    def worst(self) -> Array:
        """The largest misfit of each patch, without its sign, shape (patches,)."""
        return np.asarray(np.abs(self.misfit).max(axis=1))

    @property
    def turned_over(self) -> Bools:
        """The patches whose quadrilateral crosses itself or lies on its face, shape (patches,)."""
        return turned_over(self.corners)

    def __repr__(self) -> str:
        worst, unit = self.worst, self.atlas.unit
        return (
            f"<UnfoldedPatches of {self.atlas.name!r}: misfit {np.median(worst):.3g} {unit} in the "
            f"median, {worst.max():.3g} {unit} at most>"
        )


@one_blas_thread()
def unfold_patches(atlas: Atlas) -> UnfoldedPatches:
    """Unfold each patch of an atlas into the plane, by its six lengths.

    Parameters
    ----------
    atlas : Atlas

    Returns
    -------
    UnfoldedPatches
        It is a diagnosis of the body and not yet a pattern: neighboring patches are unfolded each
        by itself, so that the sides they share differ by their misfits.

    Raises
    ------
    InputError
        If a patch is collapsed to a point.
    ConvergenceError
        If a diagonal has no length that can be trusted.

    Notes
    -----
    This is the Bijective Pattern Map of Ng, Pong and Wong (2007). A patch has four boundary curves
    and two diagonals, and a quadrilateral has five degrees of freedom: the one equation that is
    left over is the curvature. Over a geodesic square that is small, the misfits of the diagonals
    less those of the sides add up to ``-(2 + sqrt(2)) / 24`` times the integral of the Gaussian
    curvature, times the square root of the area.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> unfolded = bm.unfold_patches(bm.load_sample("female_average"))
    >>> unfolded  # doctest: +ELLIPSIS
    <UnfoldedPatches of 'Average female body, 160.5 cm': misfit ... m in the median, ... m at most>
    >>> bool(unfolded.turned_over.any())
    False
    """
    solutions = diagonals(atlas)
    sides = boundary_lengths(atlas).length
    # The sides come in the order of EDGES: u = 0, u = 1, v = 0, v = 1.
    lengths = np.concatenate([sides[:, [2, 1, 3, 0]], solutions.length], axis=1)
    return UnfoldedPatches(atlas, flat_quadrilaterals(lengths), lengths)
