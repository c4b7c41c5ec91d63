"""What a fit cannot see, as the page on scans says: another person is measured without a word."""

from pathlib import Path

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.fit.model import atlas_of_vertices

pytestmark = pytest.mark.slow
SCANS = Path(__file__).parents[1] / "data" / "scans"


@pytest.mark.parametrize(
    ("change", "right"),
    [((-1.0, 1.0, 1.0), "left"), ((1.08, 1.08, 1.08), "right")],
    ids=["mirrored", "larger by 8 %"],
)
def test_a_wrong_body_is_measured_without_a_warning(
    change: tuple[float, float, float], right: str
) -> None:
    scan = bm.read_scan(SCANS / "coarse.ply", file_unit="m")
    body = bm.fit_body((scan.vertices * change, scan.triangles), file_unit="m", up="+z")
    assert body.warnings == ()
    with np.load(SCANS / "coarse_truth.npz") as data:
        true = data["vertices"] * change
    true = atlas_of_vertices(true @ body.transform[:3, :3].T + body.transform[:3, 3])
    # The right elbow of a mirrored person is the left one of the person; that of a larger one is
    # where it would be, which is 9 cm from where it should be.
    elbow = body.atlas.position("elbow point right")
    assert np.linalg.norm(elbow - true.position(f"elbow point {right}")) < 0.02
