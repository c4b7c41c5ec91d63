"""Shortest paths on ellipsoids, found without patches: geodesics shot from a point in space."""

import numpy as np
import scipy

from bodymeasure._typing import Array

# Directions in which geodesics leave the start at first.
DIRECTIONS = 48
# How much farther than the longest half of an ellipse they are followed, and how close they have to
# pass the end to be refined, as a part of the longest axis.
FURTHER, CLOSE = 1.05, 0.3
TOLERANCE = 1e-13


def ellipsoid_distance(axes: tuple[float, float, float], start: Array, end: Array) -> float:
    """The length of the shortest path between two points of x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1.

    With A the diagonal matrix of the inverse squares, a geodesic is a curve of constant speed with
    ``x'' = -(x' A x') / |A x|^2 A x``. Those from the start in all directions are followed, and the
    ones that pass closest to the end are made to hit it by Newton's method.
    """
    inverse = 1.0 / np.square(axes)
    normal = inverse * start
    first = np.linalg.svd(normal[None])[2][1:]
    longest = np.pi * max(axes) * FURTHER
    angles = np.linspace(0.0, 2.0 * np.pi, DIRECTIONS, endpoint=False)
    times = np.linspace(0.0, longest, 241)
    tracks = _follow(inverse, start, first, angles, times, 1e-6)
    misses = np.linalg.norm(tracks[:, :3] - end[None, :, None], axis=1)
    # The way to a close point is nearly straight.
    chord = first @ (end - start)
    guesses = [(float(np.arctan2(chord[1], chord[0])), float(np.linalg.norm(end - start)))]
    nearest = misses.min(axis=1)
    beside = np.minimum(np.roll(nearest, 1), np.roll(nearest, -1))
    for row in np.flatnonzero(nearest <= beside).tolist():
        passes = scipy.signal.argrelmin(misses[row], mode="clip")[0].tolist()
        close = [at for at in passes if misses[row, at] < CLOSE * max(axes)]
        guesses += [(float(angles[row]), float(times[at])) for at in close]
    found = (_hit(inverse, (start, end), first, guess) for guess in guesses)
    return min(length for length in found if length is not None)


def _follow(
    inverse: Array, start: Array, frame: Array, angles: Array, times: Array, tolerance: float
) -> Array:
    """Positions and velocities of geodesics at times, shape (directions, 6, times)."""
    velocity = np.cos(angles)[:, None] * frame[0] + np.sin(angles)[:, None] * frame[1]
    state = np.concatenate([np.broadcast_to(start, velocity.shape), velocity], axis=1)

    def slope(_: float, flat: Array) -> Array:
        x, v = np.split(flat.reshape(-1, 6), 2, axis=1)
        normal = inverse * x
        rate = (v * inverse * v).sum(axis=1) / (normal**2).sum(axis=1)
        return np.concatenate([v, -rate[:, None] * normal], axis=1).ravel()

    solved = scipy.integrate.solve_ivp(
        slope, (0.0, times[-1]), state.ravel(), "DOP853", times, rtol=tolerance, atol=tolerance
    )
    return np.asarray(solved.y.reshape(len(angles), 6, len(times)))


def _hit(
    inverse: Array, ends: tuple[Array, Array], frame: Array, guess: tuple[float, float]
) -> float | None:
    """The length at which a geodesic hits the end, by Newton's method; None if it misses."""
    (start, end), (angle, length) = ends, guess
    for _ in range(8):
        if not 0.0 < length < 100.0:
            return None
        step = 1e-6
        tracks = _follow(
            inverse,
            start,
            frame,
            np.array([angle, angle + step, angle - step]),
            np.array([0.0, length]),
            TOLERANCE,
        )[:, :, 1]
        miss = end - tracks[0, :3]
        aside = (tracks[1, :3] - tracks[2, :3]) / (2.0 * step)
        moved = np.linalg.lstsq(np.stack([aside, tracks[0, 3:]], axis=1), miss, rcond=None)[0]
        if np.linalg.norm(miss) < 3e-12:
            return float(length + moved[1])
        moved *= min(1.0, 0.3 / float(np.abs(moved).max()))
        angle, length = angle + moved[0], length + moved[1]
    return None
