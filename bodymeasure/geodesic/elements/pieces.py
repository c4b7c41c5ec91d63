r"""The elements of a path, each measured on its own.

For an element with its ends fixed, `lengths.measure` gives the excess of its length and an estimate
of the rest. That does not serve all elements:

- *On an edge* of the patch a path is no geodesic. There an element is exact, whatever its speed.
- *Rough* elements are those on which the formulas are not to be trusted, as beside a point where
  the surface is singular, and those on which the path begins to run along an edge, where its
  curvature jumps. No path between the ends of an element is shorter than its chord. So its length
  less its chord is its error, and the chord stands for its tangents. If it leaves the patch between
  its nodes, the way back adds as much as it is outside, which is more than it makes longer.
"""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.elements.path import DEGREE, ElementPath
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.lengths.jacobi import QUADRATURE_SAFETY, SAFETY
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# Rounding errors of lengths, and of chords on a surface of size 1.
ROUNDING = 1e-15


@dataclass(frozen=True, eq=False)
class Pieces:
    """The elements of a path.

    Parameters
    ----------
    values : ndarray, shape (elements, 2, DEGREE + 1)
    lengths : ndarray, shape (elements,)
    single : Length
        What `lengths.measure` says of each.
    on_edge, rough : ndarray of bool, shape (elements,)
    speed, kappa, curvature : ndarray, shape (points, elements)
        The speed, the geodesic curvature and the Gaussian curvature at the points of each element's
        quadrature; zero where they are not finite.
    tangents, normals : ndarray, shape (3, elements, 2)
        Unit vectors at both ends: of the path, or the chord of a rough element, and of the surface.
    chords : ndarray, shape (elements,)
    outside : ndarray, shape (elements,)
        How far each leaves the patch.
    """

    values: Array
    lengths: Array
    single: Length
    on_edge: Bools
    rough: Bools
    speed: Array
    kappa: Array
    curvature: Array
    tangents: Array
    normals: Array
    chords: Array
    outside: Array

    @property
    def smooth(self) -> Bools:
        """The elements on which the formulas hold, shape (elements,)."""
        return ~(self.rough | self.on_edge)

    @property
    def correction(self) -> Array:
        """The excess of each element's length that is known, shape (elements,)."""
        return np.where(self.smooth, self.single.correction, 0.0)

    @property
    def error(self) -> Array:
        """The error of each element's length, its ends fixed, shape (elements,)."""
        space = polynomial_space(DEGREE)
        rounding = ROUNDING * (self.lengths + self.rough)
        with np.errstate(all="ignore"):
            quadrature = np.nan_to_num(space.quadrature.error_estimate(self.speed), nan=np.inf)
        error = np.where(self.smooth, self.single.error, SAFETY * QUADRATURE_SAFETY * quadrature)
        # A length below the chord is one that the quadrature has missed.
        excess = np.abs(self.lengths - self.chords)
        return np.asarray(np.where(self.rough, excess + self.outside, error) + rounding)


def pieces_of(surface: Surface, path: ElementPath, held: Bools) -> Pieces:
    """Return the elements of a path.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    path : ElementPath
    held : ndarray of bool, shape (elements, 2, DEGREE + 1)
        The coordinates of the nodes that their bounds hold.
    """
    space, values = polynomial_space(DEGREE), path.values
    own = surface.take(np.zeros(len(values), np.int64))
    moved = values - values[:, :, :1]
    place, *slopes = space.at_quadrature
    with np.errstate(all="ignore"):
        single = measure_length(own, space, values)
        geometry = path_geometry(own, values @ place.T, *(moved @ rows.T for rows in slopes))
    speed, kappa, curvature = (np.nan_to_num(each, posinf=0.0, neginf=0.0) for each in geometry)
    ends = np.ascontiguousarray(values[:, :, [0, -1]].transpose(0, 2, 1))
    position, s_u, s_v = own.jet(ends, 1)
    du, dv = (moved @ space.matrices([0.0, 1.0])[1].T).transpose(1, 0, 2)
    chord = position[:, :, 1] - position[:, :, 0]
    on_edge = path.on_edge
    known = single.trusted & np.isfinite(single.error)
    rough = ~on_edge & (~known | _meets_edge(path, held))
    tangents = np.where(rough[:, None], unit(chord)[:, :, None], unit(s_u * du + s_v * dv))
    return Pieces(
        values=values,
        lengths=space.quadrature.weights @ speed,
        single=single,
        on_edge=on_edge,
        rough=rough,
        speed=speed,
        kappa=kappa,
        curvature=curvature,
        tangents=tangents,
        normals=unit(np.cross(s_u, s_v, axis=0)),
        chords=np.sqrt(dot(chord, chord)),
        outside=path.outside * np.sqrt(np.maximum(dot(s_u, s_u), dot(s_v, s_v))).max(axis=1),
    )


def _meets_edge(path: ElementPath, held: Bools) -> Bools:
    """The elements that an edge holds for a part, or that leave the patch between their nodes."""
    values = path.values
    result = path.overshoots | held[:, :, 1:-1].any(axis=(1, 2))
    # An edge may hold a joint alone; in a corner of the patch a path may bend.
    in_corner = (np.abs(values[1:, :, 0] - 0.5) == 0.5).all(axis=1)
    alone = held[1:, :, 0].any(axis=1) & ~in_corner & ~path.on_edge[1:] & ~path.on_edge[:-1]
    result[1:] |= alone
    result[:-1] |= alone
    return np.asarray(result)


def unit(vectors: Array) -> Array:
    """Return vectors, whose components run along axis 0, of length 1; zero stays zero."""
    size = np.sqrt(dot(vectors, vectors))
    return np.asarray(vectors / np.where(size > 0.0, size, 1.0))
