"""Curves on the skin as they lie on the cloth above it."""

from dataclasses import replace

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.curves.skin_curve import SkinCurve

# In meters: chords by which a curve on the cloth is measured. Those of half as many tell by how
# much they are shorter than the arcs.
CHORD = 0.001
FEWEST = 64
# Halvings of a chord that find where it goes over to another patch, to rounding.
HALVINGS = 40


def on_cloth(curve: SkinCurve, cloth: Cloth) -> SkinCurve:
    """Return a curve whose lengths are those on the cloth above it.

    Its places are those of the skin below, by lengths on the cloth.
    """
    if cloth.ease is None:
        return curve
    arcs, run = [np.zeros(1)], [np.zeros(1)]
    # Patch by patch: a chord over the kink between two of them would be too short by some 1e-5 mm,
    # and by how much would depend on where it begins, so that seams would differ.
    for low, high in _spans(curve, cloth.atlas.unit.meters):
        count = 2 * max(4, int(np.ceil((high - low) * cloth.atlas.unit.meters / CHORD)))
        within = low + (high - low) * np.linspace(0.0, 1.0, count + 1)
        points = cloth.positions(*curve.places(within))
        chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
        fine = float(chords.sum())
        coarse = float(np.linalg.norm(np.diff(points[::2], axis=0), axis=1).sum())
        arcs.append(within[1:])
        run.append(run[-1][-1] + np.cumsum(chords) * (1.0 + (fine - coarse) / 3.0 / fine))
    length = float(run[-1][-1])
    to_skin = scipy.interpolate.PchipInterpolator(np.concatenate(run), np.concatenate(arcs))
    below = curve.places

    def places(arc: Array) -> tuple[Ints, Array]:
        return below(to_skin(np.clip(arc, 0.0, length)))

    return replace(curve, length=length, places=places)


def _spans(curve: SkinCurve, meters: float) -> list[tuple[float, float]]:
    """Return the parts of a curve that are each on one patch, by lengths from its start."""
    count = max(FEWEST, int(np.ceil(curve.length * meters / CHORD)))
    arcs = curve.length * np.linspace(0.0, 1.0, count + 1)
    patch, _ = curve.places(arcs)
    over = np.flatnonzero(patch[1:] != patch[:-1])
    low, high = arcs[over], arcs[over + 1]
    for _ in range(HALVINGS if len(over) else 0):
        middle = 0.5 * (low + high)
        before = curve.places(middle)[0] == patch[over]
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    starts, stops = [0.0, *high.tolist()], [*low.tolist(), curve.length]
    # What is shorter than rounding is no part: a curve may end just beyond a side.
    least = 1e-9 * curve.length
    return [(a, b) for a, b in zip(starts, stops, strict=True) if b - a > least]


def stretched(curve: SkinCurve, length: float) -> SkinCurve:
    """Return a curve with another length, evenly stretched."""
    below, part = curve.places, curve.length / length
    return replace(curve, length=length, places=lambda arc: below(part * arc))
