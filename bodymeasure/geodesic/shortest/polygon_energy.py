"""The energy of polygons on patches to the second order, for descent and for finding saddles."""

from dataclasses import dataclass, fields
from typing import Self

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.surfaces.protocol import Surface

# The part of its mean that is added to the metric, which vanishes on a collapsed edge.
REGULARIZATION = 1e-10
# The stiffness, relative to the metric, that stands for a coordinate that its bound holds.
STIFF = 1e3


@dataclass(frozen=True)
class PolygonEnergy:
    """Energies of polygons, and their derivatives by the k inner points.

    The energy of a polygon of m edges is m times the sum of their squares; its minimum has edges of
    equal length and the least length. The Hessian is block tridiagonal; on its diagonal stands the
    metric, as for the energy of a flat patch, plus a part that the bending of the surface makes.

    Parameters
    ----------
    energy : ndarray, shape (polygons,)
    gradient : ndarray, shape (2, k, polygons)
    metric, bending : ndarray, shape (2, 2, k, polygons)
    lower : ndarray, shape (2, 2, k - 1, polygons)
        The blocks below the diagonal.
    held : ndarray of bool, shape (2, k, polygons)
        The coordinates that their bound holds: they are on it, and pulled outwards.
    """

    energy: Array
    gradient: Array
    metric: Array
    bending: Array
    lower: Array
    held: Bools

    def take(self, polygons: Ints) -> Self:
        """Return the energies of some of the polygons."""
        return type(self)(*(getattr(self, item.name)[..., polygons] for item in fields(self)))

    def replaced(self, polygons: Bools, other: Self) -> Self:
        """Return the energies with those of another batch put in for some of the polygons."""
        if polygons.all():
            return other
        return type(self)(
            *(
                np.where(polygons, getattr(other, item.name), getattr(self, item.name))
                for item in fields(self)
            )
        )

    def restricted_hessian(self, damping: Array | float) -> tuple[Array, Array]:
        """Return the blocks on and below the diagonal of the Hessian of the free coordinates.

        A multiple of the metric is added. Coordinates that are held stand alone in it.
        """
        free = ~self.held
        diagonal = self.bending + (1.0 + damping) * self.metric
        diagonal *= free[:, None] & free
        for axis in (0, 1):
            diagonal[axis, axis] += STIFF * self.held[axis] * self.metric[axis, axis]
        return diagonal, self.lower * (free[:, None, 1:] & free[:, :-1])


def polygon_lengths(surface: Surface, points: Array) -> Array:
    """Return the lengths of inscribed polygons: sums of straight distances between neighbors.

    They are a little less than those of the paths on the surface that the polygons stand for.
    """
    steps = np.diff(surface.jet(points, 0)[0], axis=-1)
    result: Array = np.sqrt(dot(steps, steps)).sum(axis=-1)
    return result


def polygon_energy(surface: Surface, points: Array) -> PolygonEnergy:
    """Return the energies of polygons with points (u, v) of shape (polygons, k + 2, 2)."""
    edges = points.shape[1] - 1
    # The polygons, of which there are many, run along the last axis.
    jet = np.ascontiguousarray(surface.jet(points, 2).swapaxes(2, 3))
    step = np.diff(jet[0], axis=1)
    bend = step[:, :-1] - step[:, 1:]
    inner_jet = jet[:, :, 1:-1]
    tangents, factor = inner_jet[1:3], 2.0 * edges
    along_bend = np.einsum("dckp,ckp->dkp", inner_jet[1:], bend)
    gradient = factor * along_bend[:2]
    metric = np.einsum("ickp,jckp->ijkp", tangents, tangents)
    mean = REGULARIZATION * (metric[0, 0] + metric[1, 1]).mean(axis=0) / 2.0
    metric[0, 0] += mean
    metric[1, 1] += mean
    bending = along_bend[[[2, 3], [3, 4]]]
    lower = np.einsum("ickp,jckp->ijkp", tangents[:, :, 1:], tangents[:, :, :-1])
    inner = points[:, 1:-1].transpose(2, 1, 0)
    return PolygonEnergy(
        energy=edges * dot(step, step).sum(axis=0),
        gradient=gradient,
        metric=2.0 * factor * metric,
        bending=factor * bending,
        lower=-factor * lower,
        held=((inner <= 0.0) & (gradient > 0.0)) | ((inner >= 1.0) & (gradient < 0.0)),
    )
