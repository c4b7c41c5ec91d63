"""Normals and bends of patches."""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.bezier.power_form import jets

# Sine: tangents closer than this span no plane, and the normal is taken a little aside.
DEGENERATE = 1e-9
ASIDE = 1e-4


def normals_and_bends(coefficients: Array, x: Array) -> tuple[Array, Array, Array]:
    """Positions, unit normals along S_u x S_v, and how they bend.

    Parameters
    ----------
    coefficients : ndarray, shape (k, m + 1, m + 1, 3 or 4)
        Of powers.
    x : ndarray, shape (k, 2)

    Returns
    -------
    position, normal : ndarray, shape (k, 3)
    bend : ndarray, shape (k, 3, 3)
        Second derivatives, by the position, of the distance to the surface at its foot, counted
        along the normal; 0 where there are no two tangents.
    """
    s = jets(coefficients, x)
    normal, sine = _unit_normal(s[:, 1, 0], s[:, 0, 1])
    bad = np.flatnonzero(sine < DEGENERATE)
    if len(bad):
        inside = x[bad] + ASIDE * (0.5 - x[bad])
        aside = jets(coefficients[bad], inside)
        normal[bad] = _unit_normal(aside[:, 1, 0], aside[:, 0, 1])[0]
    return s[:, 0, 0], normal, _bend(s, normal, sine >= DEGENERATE)


def _unit_normal(su: Array, sv: Array) -> tuple[Array, Array]:
    """Unit normals, and the sines of the angles between the tangents."""
    cross = np.cross(su, sv)
    length = np.linalg.norm(cross, axis=1)
    product = np.linalg.norm(su, axis=1) * np.linalg.norm(sv, axis=1)
    tiny = np.finfo(np.float64).tiny
    return cross / np.maximum(length, tiny)[:, None], length / np.maximum(product, tiny)


def _bend(s: Array, normal: Array, regular: Bools) -> Array:
    """Second derivatives of the distance to the surface, 0 where it has no tangents."""
    tangents = np.stack([s[:, 1, 0], s[:, 0, 1]], axis=2)
    metric = tangents.swapaxes(1, 2) @ tangents
    metric[~regular] = np.eye(2)
    dual = tangents @ np.linalg.inv(metric)
    second = np.einsum("kijc,kc->kij", s[:, [[2, 1], [1, 0]], [[0, 1], [1, 2]]], normal)
    second[~regular] = 0.0
    return np.asarray(-dual @ second @ dual.swapaxes(1, 2))
