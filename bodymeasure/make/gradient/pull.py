"""Derivatives that are gathered backwards: from a value to landmarks, and from them to the skin."""

from dataclasses import dataclass, field
from typing import Self

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bezier import bernstein


@dataclass(eq=False)
class Pull:
    """What a value changes by with each control point, and with each landmark not yet resolved.

    Parameters
    ----------
    atlas : Atlas
        With polynomial patches.
    weights : ndarray, shape (points, 3)
        The derivative with respect to each control point.
    landmarks : dict of str to ndarray, shape (3,)
        The derivative with respect to the positions of landmarks.
    given : dict of str to float
        The derivative with respect to lengths that are given with the body, by their keys.
    """

    atlas: Atlas
    weights: Array
    landmarks: dict[str, Array] = field(default_factory=dict)
    given: dict[str, float] = field(default_factory=dict)

    @classmethod
    def on(cls, atlas: Atlas) -> Self:
        """Return a pull of nothing."""
        return cls(atlas, np.zeros(atlas.points.shape))

    def skin(
        self,
        patch: Ints,
        parameters: Array,
        vectors: Array,
        order: tuple[int, int] = (0, 0),
    ) -> None:
        """Add derivatives with respect to points of the skin that stay where they are on patches.

        Parameters
        ----------
        patch : ndarray of int, shape (n,)
        parameters : ndarray, shape (n, 2)
        vectors : ndarray, shape (n, 3)
        order : (int, int)
            Which derivative by u and v is meant; the position itself if not given.
        """
        degree = self.atlas.degree
        u = bernstein(degree, parameters[:, 0], order[0])[:, order[0]]
        v = bernstein(degree, parameters[:, 1], order[1])[:, order[1]]
        basis = u[:, :, None] * v[:, None, :]
        parts = basis[..., None] * vectors[:, None, None, :]
        np.add.at(self.weights, self.atlas.index[patch], parts)

    def point(self, point: AtlasPoint, vector: Array, order: tuple[int, int] = (0, 0)) -> None:
        """Add the derivative with respect to one point of the skin."""
        self.skin(np.array([point.patch]), np.array([[point.u, point.v]]), vector[None], order)

    def at(self, landmark: str, vector: Array) -> None:
        """Add the derivative with respect to the position of a landmark."""
        self.landmarks[landmark] = self.landmarks.get(landmark, 0.0) + vector

    def add(self, other: "Pull", factor: float) -> None:
        """Add the derivatives of another value on the same atlas, times a factor."""
        self.weights += factor * other.weights
        for name, vector in other.landmarks.items():
            self.at(name, factor * vector)
        for key, share in other.given.items():
            self.given[key] = self.given.get(key, 0.0) + factor * share
