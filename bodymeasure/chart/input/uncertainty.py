"""What the value of a measurement owes to the scan that its body was fitted to."""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.queries.approximation_error import nearest_patches
from bodymeasure.chart.body import Body
from bodymeasure.chart.input.slopes import length, turning
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.kinds.formula import FormulaMeasure
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.wording import counted

# In meters: the deviations of a fitted surface at two places that are farther apart have little to
# do with one another. A fit smooths the noise of a scan over about this length.
PATCH_OF_NOISE = 0.05
# The number of patches that a message names; the others are counted.
NAMED = 4


def with_input(found: Measured, body: Body, others: Mapping[str, Measured]) -> Measured:
    """Return a measurement with the uncertainty that it has from the scan.

    It has no value if its tape or a landmark lies where the scan shows nothing.

    Parameters
    ----------
    found : Measured
    body : Body
    others : mapping of str to Measured
        The measurements that formulas name, with their uncertainties.

    Notes
    -----
    The variances of three causes are added:

    - Each landmark lies off its place along the skin by its own uncertainty, half of the variance
      in either direction; the value follows with `MeasurementDefinition.slopes`.
    - Each landmark lies above or below the true skin by the distance of its patch from the scan.
    - A tape becomes longer by the angle through which it turns, times the distance by which the
      surface is off. That distance has another sign every 5 cm or so, so that of n such stretches
      the square root counts.
    """
    scan = body.atlas.scan
    if scan is None or found.outcome is not Outcome.MEASURED:
        return found
    definition = found.definition
    computed = isinstance(definition, FormulaMeasure)
    skin = np.empty((0, 3)) if computed else definition.skin(body, found)
    under = np.unique(nearest_patches(body.atlas, skin)) if len(skin) else np.empty(0, np.int64)
    if reason := _unseen(body, definition, under):
        return Measured(definition, Outcome.NOT_SCANNED, reason, landmarks=found.landmarks)
    slopes = definition.slopes(body, found, others)
    surface = (
        found.surface_uncertainty
        if computed
        else surface_uncertainty(body.atlas, found.tape, under)
        if len(under)
        else 0.0
    )
    places = [_from_landmark(body, name, slope) for name, slope in slopes.items()]
    return replace(
        found,
        slopes=slopes,
        surface_uncertainty=surface,
        input_uncertainty=math.hypot(surface, *places),
    )


def surface_uncertainty(atlas: Atlas, tape: Tape, under: Ints) -> float:
    """Return the standard uncertainty that a tape's length has from the surface below it.

    Parameters
    ----------
    atlas : Atlas
        One that was fitted to a scan.
    tape : Tape
    under : ndarray of int, shape (k,)
        The patches below the tape.
    """
    off = _distance(atlas, under)
    if tape.kind is TapeKind.STRAIGHT:
        # Both ends of an extent move by themselves.
        return math.sqrt(2.0) * off
    stretches = length(tape) * atlas.unit.meters / PATCH_OF_NOISE
    return turning(tape) * off / math.sqrt(max(stretches, 1.0))


def unseen_patches(atlas: Atlas, under: Ints) -> str:
    """Return which of the patches below a tape the scan does not show; empty if it shows all."""
    assert atlas.scan is not None
    bare = np.intersect1d(under, atlas.scan.uncovered)
    if not len(bare):
        return ""
    names = [atlas.patch_names[patch] for patch in bare[:NAMED]]
    regions = ", ".join(sorted({atlas.regions[patch] for patch in bare} - {""}))
    more = f" and {len(bare) - NAMED} more" if len(bare) > NAMED else ""
    where = f" ({regions})" if regions else ""
    return (
        f"the tape crosses {counted(len(bare), 'patch', 'patches')} of which the scan shows less "
        f"than half: {', '.join(names)}{more}{where}; their shape is a guess of the body model; "
        "scan the body again there"
    )


def _unseen(body: Body, definition: MeasurementDefinition, under: Ints) -> str:
    """Return why the scan does not show what is measured; empty if it does."""
    atlas = body.atlas
    guessed = [name for name in definition.landmarks if name in body.trust.unseen]
    if guessed:
        root = body.trust.unseen[guessed[0]]
        follows = "" if root == guessed[0] else f", which {guessed[0]!r} follows from"
        region = atlas.regions[body.landmarks[root].patch]
        where = f" ({region})" if region else ""
        return (
            f"the scan shows nothing at {root!r}{where}{follows}; its place is a guess of the body "
            "model; scan the body again there"
        )
    return unseen_patches(atlas, under)


def _from_landmark(body: Body, name: str, slope: Array) -> float:
    """Return the standard uncertainty that a value has from a landmark."""
    point, scan = body.point(name), body.atlas.scan
    assert scan is not None
    normal = body.normals(np.array([point.patch]), np.array([[point.u, point.v]]))[0]
    off = float(slope @ normal)
    along = float(np.linalg.norm(slope - off * normal))
    aside = body.trust.uncertainty.get(name, 0.0) / math.sqrt(2.0)
    above = _distance(body.atlas, np.array([point.patch]))
    return math.hypot(along * aside, off * above)


def _distance(atlas: Atlas, patches: Ints) -> float:
    """Return the root mean square distance of patches from the scan, in the atlas's unit."""
    assert atlas.scan is not None
    known = atlas.scan.distance[patches]
    known = known[np.isfinite(known)]
    # A patch without a distance of its own, next to covered ones, is as good as all of them.
    off = math.sqrt(float((known**2).mean())) if len(known) else atlas.scan.rms
    return off / atlas.unit.meters if math.isfinite(off) else 0.0
