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


def on_cloth(curve: SkinCurve, cloth: Cloth) -> SkinCurve:
    """Return a curve whose lengths are those on the cloth above it.

    Its places are those of the skin below, by lengths on the cloth.
    """
    if cloth.ease is None:
        return curve
    count = 2 * max(FEWEST, int(np.ceil(curve.length * cloth.atlas.unit.meters / CHORD / 2.0)))
    arcs = curve.length * np.linspace(0.0, 1.0, count + 1)
    points = cloth.positions(*curve.places(arcs))
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    run = np.concatenate([[0.0], np.cumsum(chords)])
    coarse = float(np.linalg.norm(np.diff(points[::2], axis=0), axis=1).sum())
    run *= 1.0 + (run[-1] - coarse) / 3.0 / run[-1]
    to_skin = scipy.interpolate.PchipInterpolator(run, arcs)
    below = curve.places

    def places(arc: Array) -> tuple[Ints, Array]:
        return below(to_skin(np.clip(arc, 0.0, run[-1])))

    return replace(curve, length=float(run[-1]), places=places)


def stretched(curve: SkinCurve, length: float) -> SkinCurve:
    """Return a curve with another length, evenly stretched."""
    below, part = curve.places, curve.length / length
    return replace(curve, length=length, places=lambda arc: below(part * arc))
