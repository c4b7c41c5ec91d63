"""Single patches on which the length of a geodesic is known in closed form."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit

Terms = dict[tuple[int, int], float]
"""Coefficients of a polynomial by the powers of u and v."""


@dataclass(frozen=True)
class KnownSurface:
    """A polynomial surface, and what is known about it.

    `geodesic` says between which (u, v) the length is known, and what it is, in centimeters.
    """

    name: str
    title: str
    formula: str
    coordinates: tuple[Terms, Terms, Terms]
    geodesic: str


SURFACES = (
    KnownSurface(
        "enneper",
        "Enneper's surface",
        "(u - u^3/3 + u v^2, v - v^3/3 + v u^2, u^2 - v^2)",
        (
            {(1, 0): 1, (3, 0): -1 / 3, (1, 2): 1},
            {(0, 1): 1, (0, 3): -1 / 3, (2, 1): 1},
            {(2, 0): 1, (0, 2): -1},
        ),
        "(u, v) = (0, 0) to (1, 1): 5 sqrt(2) / 3 = 2.3570226039551585 cm",
    ),
    KnownSurface(
        "paraboloid",
        "Paraboloid of revolution",
        "(u, v, u^2 + v^2)",
        ({(1, 0): 1}, {(0, 1): 1}, {(2, 0): 1, (0, 2): 1}),
        "(u, v) = (0, 0) to (1, 1): 3 / sqrt(2) + asinh(2 sqrt(2)) / 4 = 2.562007137069414 cm",
    ),
    KnownSurface(
        "hyperbolic_paraboloid",
        "Hyperbolic paraboloid",
        "(u, v, u v)",
        ({(1, 0): 1}, {(0, 1): 1}, {(1, 1): 1}),
        "(u, v) = (0, 0) to (1, 1): (sqrt(6) + asinh(sqrt(2))) / 2 = 1.7978527887818834 cm",
    ),
    KnownSurface(
        "ph_cylinder",
        "Cylinder on a Pythagorean-hodograph cubic",
        "(3u - u^3, 3u^2, 3v)",
        ({(1, 0): 3, (3, 0): -1}, {(2, 0): 3}, {(0, 1): 3}),
        "(u, v) = (0, 0) to (1, 1): 5 cm; in general hypot(3 du + d(u^3), 3 dv), "
        "where d is the difference between the ends",
    ),
    KnownSurface(
        "tangent_developable",
        "Tangent developable of a twisted cubic",
        "c(u) + (v + 1/2) c'(u) with c(u) = (3u, 3u^2, 2u^3)",
        (
            {(0, 0): 1.5, (1, 0): 3, (0, 1): 3},
            {(1, 0): 3, (2, 0): 3, (1, 1): 6},
            {(2, 0): 3, (3, 0): 2, (2, 1): 6},
        ),
        "(u, v) = (0, 1) to (1, 0.3): 10.795929801053113 cm, the chord after unrolling, in which "
        "the tangent turns by sqrt(2) atan(sqrt(2) u)",
    ),
)


def known_surfaces() -> Iterator[tuple[str, Atlas]]:
    """Name of the file, and atlas, of each surface."""
    for surface in SURFACES:
        net = np.stack([_control_values(terms) for terms in surface.coordinates], axis=-1)
        yield (
            surface.name,
            Atlas(
                points=net.reshape(-1, 3),
                index=np.arange(16).reshape(1, 4, 4),
                unit=Unit.CM,
                patch_names=(surface.name.replace("_", " "),),
                name=surface.title,
                provenance={
                    "formula": f"{surface.formula} in cm, on [0, 1] x [0, 1]",
                    "known geodesic": surface.geodesic,
                    "method": "monomial coefficients converted to bicubic Bezier control points",
                    "license": "CC0 1.0",
                },
            ),
        )


def _control_values(terms: Terms) -> Array:
    """Bezier ordinates (4, 4) of one coordinate: u^k is the sum of C(i, k) / C(3, k) B_i(u)."""
    coefficients = np.zeros((4, 4))
    for powers, value in terms.items():
        coefficients[powers] = value
    conversion = np.array([[math.comb(i, k) / math.comb(3, k) for k in range(4)] for i in range(4)])
    return np.asarray(conversion @ coefficients @ conversion.T)
