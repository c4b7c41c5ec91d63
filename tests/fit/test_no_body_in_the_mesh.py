"""Meshes of which only the fit can tell that they are no whole body: none is measured."""

import numpy as np
import pytest
from helpers.scans.meshes import Mesh, chair, ellipsoid, joined

from bodymeasure.errors import FitError
from bodymeasure.fit import fit_body
from bodymeasure.fit.model import body_model, limit_matrix


def mean_body() -> Mesh:
    """The mean body of the space, on its limit positions."""
    model = body_model()
    quads = model.quads
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return limit_matrix() @ model.mean, triangles


def _part(low: float, high: float) -> Mesh:
    """The mean body between two heights."""
    vertices, triangles = mean_body()
    height = vertices[triangles].mean(axis=1)[:, 2]
    return vertices, triangles[(height > low) & (height < high)]


def _two_people() -> Mesh:
    """Two bodies through each other, as two people that embrace are scanned."""
    vertices, triangles = mean_body()
    return joined((vertices, triangles), (vertices + np.array([0.35, 0.12, 0.0]), triangles))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("mesh", "said"),
    [
        (chair(), r"the fitted body is .* m tall; .* one of a standing person and of nothing else"),
        (ellipsoid((0, 0, 0), (0.85, 0.85, 0.85), 32), "no body was found in the mesh"),
        (ellipsoid((0, 0, 0), (0.3, 0.2, 0.85), 32), "has scan within 12 mm; .* check the unit"),
        (_two_people(), "of the fitted body has scan within 12 mm; expected at least 90% of one"),
        (_part(0.6, 2.0), "of the fitted body has scan within 12 mm; .* scan what is missing"),
        (_part(0.0, 1.05), "of the fitted body has scan within 12 mm; .* scan what is missing"),
    ],
    ids=["chair", "ball", "egg", "two people", "without legs", "legs alone"],
)
def test_it_is_refused(mesh: Mesh, said: str) -> None:
    with pytest.raises(FitError, match=f"^the mesh: .*{said}"):
        fit_body(mesh, file_unit="m")
