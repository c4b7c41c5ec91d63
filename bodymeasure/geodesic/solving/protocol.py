"""The interface of methods, and the batches of paths that they return."""

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.lengths.arc_length_times import times_at
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.varying_speed import VaryingSpeed
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface


@dataclass(frozen=True)
class EdgeContact:
    """A part of a path that runs along an edge of its patch.

    Parameters
    ----------
    edge : str
        The name of the edge, as in `bodymeasure.atlas.EDGES`, such as ``u = 0``.
    start, end : float
        The values, at both ends of the part, of the parameter that runs along the edge.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> contact = bm.EdgeContact("u = 0", start=0.25, end=0.75)
    >>> contact.end - contact.start
    0.5
    """

    edge: str
    start: float
    end: float


@dataclass(frozen=True)
class PathBatch:
    """The paths of those problems of a batch that were solved on one trial space.

    Parameters
    ----------
    problems : ndarray of int, shape (k,)
    space : TrialSpace
    values : ndarray, shape (k, 2, n + 1)
        The values of u and v at the space's nodes.
    length : Length
        The lengths of the paths, with arrays of shape (k,).
    converged, singular : ndarray of bool, shape (k,)
    contacts : tuple of EdgeContact
        The edges of its patch that the path runs along; only a batch of one path has any.
    speed : VaryingSpeed, optional
        The speed, if it is not constant: then t is not the part of the length that has been
        covered.
    reach : ndarray, shape (k,), optional
        How far the paths go outside their patch in u or v, below 0 inside, if that is known.
    chord : ndarray, shape (k,), optional
        The distances of their ends in space, if they are known.
    """

    problems: Ints
    space: TrialSpace
    values: Array
    length: Length
    converged: Bools
    singular: Bools
    contacts: tuple[EdgeContact, ...] = ()
    speed: VaryingSpeed | None = None
    reach: Array | None = None
    chord: Array | None = None

    def take(self, rows: Ints) -> "PathBatch":
        """Return some of the paths, by their place in this batch."""
        return PathBatch(
            self.problems[rows],
            self.space,
            self.values[rows],
            self.length.take(rows),
            self.converged[rows],
            self.singular[rows],
            self.contacts,
            None if self.speed is None else self.speed.take(rows),
            None if self.reach is None else self.reach[rows],
            None if self.chord is None else self.chord[rows],
        )

    def leaves_patch(self, margin: float) -> Bools:
        """Return which paths go further than a margin outside [0, 1], in u or v."""
        if self.reach is None:
            return self.space.leaves_patch(self.values, margin)
        result: Bools = self.reach > margin
        return result

    def points(self, parts: Array) -> Array:
        """Return (u, v) after parts of the paths' lengths, shape (problems, parts, 2)."""
        if self.speed is None:
            places = self.values @ self.space.matrices(parts)[0].T
            points = np.ascontiguousarray(places.transpose(0, 2, 1))
        else:
            speed = self.speed.at_quadrature(self.space, self.values)
            times = times_at(self.space.quadrature, speed, parts)
            points = self.space.functions.combined(self.values, times)
        if self.contacts:
            # A path along an edge stays in the patch; polynomials may leave it by a little.
            points = np.clip(points, 0.0, 1.0)
        points[:, parts == 0.0] = self.values[:, None, :, 0]
        points[:, parts == 1.0] = self.values[:, None, :, -1]
        return points

    def alone(self) -> "PathBatch":
        """Return the same paths without what belongs to others of their problems' batch."""
        return self if self.speed is None else replace(self, speed=self.speed.alone())

    def renumbered(self, problems: Ints) -> "PathBatch":
        """Return the same paths under other problem numbers."""
        return replace(self, problems=problems)


@dataclass(frozen=True)
class MethodResult:
    """The paths that a method found for a batch of problems.

    Parameters
    ----------
    batches : tuple of PathBatch
        The paths; every problem is in exactly one of the batches.
    iterations : ndarray of int, shape (problems,)
    """

    batches: tuple[PathBatch, ...]
    iterations: Ints


class Method(Protocol):
    """A way to solve geodesic boundary value problems: a frozen dataclass of its settings."""

    @property
    def tolerance(self) -> float:
        """The relative error of the length that is asked for."""

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
