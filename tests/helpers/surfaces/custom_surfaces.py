"""Surfaces that are given by their derivatives, as a user may give them."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives

ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))


def wave(amplitude: float, frequency: float, phase: float, x: Array) -> list[Array]:
    """The function ``amplitude cos(frequency x + phase)`` and its first three derivatives."""
    return [
        amplitude * frequency**k * np.cos(frequency * x + phase + k * math.pi / 2) for k in range(4)
    ]


def product(a: list[Array], b: list[Array]) -> Array:
    """All derivatives of a(u) b(v), shape (..., 10)."""
    return np.stack([a[i] * b[j] for i, j in ORDERS], axis=-1)


@dataclass(frozen=True)
class Torus:
    """The tube of radius r around a circle of radius R; with R = 0 it is a sphere."""

    R: float
    r: float
    span_u: float = 1.0
    span_v: float = 1.0
    begin_v: float = -0.5

    def derivatives(self, parameters: Array) -> Array:
        u, v = parameters[..., 0], parameters[..., 1]
        out = wave(self.r, self.span_v, self.begin_v, v)
        out[0] = out[0] + self.R
        one = [np.ones_like(u), 0 * u, 0 * u, 0 * u]
        return np.stack(
            [
                product(wave(1.0, self.span_u, 0.0, u), out),
                product(wave(1.0, self.span_u, -math.pi / 2, u), out),
                product(one, wave(self.r, self.span_v, self.begin_v - math.pi / 2, v)),
            ],
            axis=-1,
        )


@dataclass(frozen=True)
class Patch:
    """A Bezier patch that follows the protocol for the user's own surfaces."""

    net: Any

    def derivatives(self, parameters: Array) -> Array:
        d = derivatives(self.net, parameters, order=3)
        return np.stack([d[..., i, j, :] for i, j in ORDERS], axis=-2)
