"""How far a tape can be trusted on a body that was fitted to a scan."""

from typing import Any

import numpy as np
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.atlas.queries.approximation_error import nearest_patches
from bodymeasure.chart import Tape, TapeKind
from bodymeasure.chart.input.uncertainty import surface_uncertainty, unseen_patches

# In meters: steps of a tape that are shorter have no direction, since points are rounded.
LEAST_STEP = 1e-5
REMARK = (
    " The body was fitted to a scan: how far its surface is from it counts as the error, where "
    "that is more; how well the points are placed comes on top."
)


def on_scan(body: ShownBody, answer: dict[str, Any]) -> dict[str, Any]:
    """Return the answer about a tape with what the scan leaves open, as a chart tells it.

    A tape over patches that the scan does not show has no length. Other lengths get
    ``uncertainty``, in meters. On a body that is no fit, the answer stays as it is.
    """
    if body.atlas.scan is None or answer["length"] is None:
        return answer
    points, normals = np.array(answer["points"]), np.array(answer["normals"])
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1)
    kept = np.concatenate([[True], apart > LEAST_STEP])
    points, normals = points[kept], normals[kept]
    positions = points @ body.rotation / body.meters
    under = np.unique(nearest_patches(body.atlas, positions[normals.any(axis=1)]))
    if unseen := unseen_patches(body.atlas, under):
        words = f"{unseen[:1].upper()}{unseen[1:]}."
        return {**answer, "length": None, "status": "not_scanned", "words": words}
    tape = Tape(TapeKind(answer["kind"]), positions, normals)
    uncertainty = surface_uncertainty(body.atlas, tape, under) * body.meters
    return {**answer, "uncertainty": uncertainty, "words": answer["words"] + REMARK}
