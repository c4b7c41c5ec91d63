"""Bodies whose shape is sent along: atlases, and rows of arrays of many bodies."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, GivenLength
from bodymeasure.chart import found_landmarks
from bodymeasure.errors import InputError
from bodymeasure.extremities import extremity_lengths
from bodymeasure.fit.completed import completed
from bodymeasure.fit.model import atlas_of_vertices, body_model, shaped
from bodymeasure.surveys.bodies.surveyed import Asked, Body, Layout, unique_names


@dataclass(frozen=True, eq=False)
class AtlasBody:
    """An atlas that is there already."""

    name: str
    held: Atlas
    source: str = ""

    def atlas(self, asked: Asked) -> Atlas:  # noqa: ARG002
        """Return the atlas."""
        return self.held


@dataclass(frozen=True, eq=False)
class PointsBody:
    """A body with the patches of a layout.

    Parameters
    ----------
    name, source : str
    points : ndarray, shape (n, 3)
        Its control points, in the layout's unit.
    given : mapping of str to GivenLength
    """

    name: str
    source: str
    points: Array
    given: Mapping[str, GivenLength]

    def atlas(self, asked: Asked) -> Atlas:
        """Return the body on the layout."""
        assert asked.layout is not None
        return replace(asked.layout, points=self.points, name=self.name, given=self.given)


@dataclass(frozen=True, eq=False)
class VerticesBody:
    """A body given by the vertices of the quad mesh of the space of bodies.

    Parameters
    ----------
    name, source : str
    vertices : ndarray, shape (13380, 3)
        In meters, z up, front = -y.
    """

    name: str
    source: str
    vertices: Array

    def atlas(self, asked: Asked) -> Atlas:
        """Return the body with its landmarks, and with lengths of head, hands and feet."""
        _require_finite(self.vertices, "vertices")
        return body_of_vertices(self.vertices, self.name, extremities=asked.extremities)


@dataclass(frozen=True, eq=False)
class ShapeBody:
    """A body of the space of bodies.

    Parameters
    ----------
    name, source : str
    coefficients : ndarray, shape (k,)
        In standard deviations.
    """

    name: str
    source: str
    coefficients: Array

    def atlas(self, asked: Asked) -> Atlas:
        """Return the body with its landmarks, and with lengths of head, hands and feet."""
        _require_finite(self.coefficients, "coefficients")
        vertices = shaped(self.coefficients)
        return body_of_vertices(vertices, self.name, extremities=asked.extremities)


def _require_finite(values: Array, words: str) -> None:
    if not np.isfinite(values).all():
        raise InputError(f"its {words} are not all finite; give numbers")


def body_of_vertices(vertices: Array, name: str, *, extremities: bool = True) -> Atlas:
    """Return the atlas of a body of the quad mesh, as complete as the mesh makes it.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
    name : str
    extremities : bool
        Whether with lengths of head, hands and feet.
    """
    atlas = atlas_of_vertices(vertices, name=name)
    return completed(atlas, vertices) if extremities else found_landmarks(atlas).atlas


@cache
def extremity_keys() -> frozenset[str]:
    """Return the keys of the measurements that head, hands and feet of the quad mesh give."""
    model = body_model()
    return frozenset(extremity_lengths(model.mean, model.quads))


class HeldAtlases:
    """Atlases as the bodies of a survey.

    Parameters
    ----------
    atlases : sequence of Atlas
    """

    layout: Layout = None

    def __init__(self, atlases: Sequence[Atlas]) -> None:
        if not atlases:
            raise InputError("there is no body to survey; expected at least one")
        self._atlases = tuple(atlases)
        named = [atlas.name or f"body {number}" for number, atlas in enumerate(atlases, start=1)]
        self._names = tuple(unique_names(named))

    def __len__(self) -> int:
        return len(self._atlases)

    def identity(self) -> dict[str, object]:
        """Return digests of what the values of the bodies depend on."""
        digest = hashlib.sha256()
        for name, atlas in zip(self._names, self._atlases, strict=True):
            rest = (name, sorted(atlas.landmarks.items()), atlas.axes, sorted(atlas.given.items()))
            digest.update(f"{atlas.digest} {rest!r}".encode("utf-8", "surrogatepass"))
        return {"atlases": len(self), "SHA-256": digest.hexdigest()}

    def between(self, start: int, stop: int) -> Sequence[Body]:
        """Return some of the bodies."""
        names, atlases = self._names[start:stop], self._atlases[start:stop]
        return [AtlasBody(*each) for each in zip(names, atlases, strict=True)]
