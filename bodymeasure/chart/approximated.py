"""The error that the approximation of an atlas adds to a measurement."""

from dataclasses import replace

import numpy as np

from bodymeasure.atlas import Atlas, approximation_error
from bodymeasure.atlas.approximation import extent
from bodymeasure.atlas.queries.approximation_error import distances_from_surface
from bodymeasure.chart.kinds.base import Measured, Outcome
from bodymeasure.chart.tapes import TapeKind


def approximated(found: Measured, atlas: Atlas) -> Measured:
    """Return a measurement with its error from the atlas's approximation, and that of its mesh.

    A tape differs by the stretch of the patches below it (`approximation_error`), and a straight
    distance by the distance of the surface at both ends. On the mesh, a tape is longer by the
    relative difference of lengths, and a straight distance by twice the root mean square distance.
    A formula has computed both from those of its operands.
    """
    approximation = atlas.approximation
    done = found.approximation_error is not None
    if approximation is None or found.outcome is not Outcome.MEASURED or done:
        return found
    taut_or_contact = [tape for tape in found.tapes if tape.kind is not TapeKind.STRAIGHT]
    if taut_or_contact:
        error = max(approximation_error(atlas, tape.points) for tape in taut_or_contact)
        difference = approximation.mesh_lengths * found.value
    else:
        ends = [tape.points[[0, -1]] for tape in found.tapes]
        error = max(float(distances_from_surface(atlas, pair).sum()) for pair in ends)
        away = 2.0 * extent(atlas.points) * approximation.mesh_rms
        difference = float(np.copysign(away, approximation.mesh_lengths))
    return replace(found, approximation_error=error, mesh_difference=difference)
