"""Curves on the skin as they lie on the cloth above it."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.curves.skin_curve import SkinCurve

# In meters: chords by which a curve on the cloth is measured. Those of half as many tell by how
# much they are shorter than the arcs.
CHORD = 0.001
# A part of a curve that is shorter than this part of it is rounding.
LEAST = 1e-9
# Its ends are moved inwards by such a part of it, so that they lie on its own patch.
BESIDE = 1e-12


def on_cloth(curve: SkinCurve, cloth: Cloth) -> SkinCurve:
    """Return a curve whose lengths are those on the cloth above it.

    Its places are those of the skin below, by lengths on the cloth.
    """
    if cloth.ease is None:
        return curve
    arcs, run = [np.zeros(1)], [np.zeros(1)]
    # Patch by patch: a chord over the kink between two of them would be too short by some 1e-5 mm,
    # and by how much would depend on where it begins, so that seams would differ.
    spans = _spans(curve)
    for low, high in spans:
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

    turns = np.array([part[-1] for part in run[1:-1]])
    return replace(curve, length=length, places=places, turns=turns)


def _spans(curve: SkinCurve) -> list[tuple[float, float]]:
    """Return the parts of a curve that are each on one patch, by lengths from its start."""
    bounds = [0.0, *curve.turns.tolist(), curve.length]
    # What is shorter than rounding is no part: a curve may end just beyond a side.
    least, aside = LEAST * curve.length, BESIDE * curve.length
    return [(low + aside, high - aside) for low, high in pairwise(bounds) if high - low > least]


def stretched(curve: SkinCurve, length: float) -> SkinCurve:
    """Return a curve with another length, evenly stretched."""
    below, part = curve.places, curve.length / length

    def places(arc: Array) -> tuple[Ints, Array]:
        return below(part * arc)

    return replace(curve, length=length, places=places, turns=curve.turns / part)
