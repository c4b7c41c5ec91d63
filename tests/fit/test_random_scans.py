"""Random bodies with other skin, poses, triangles and noise than the model's come back."""

import numpy as np
import pytest
from helpers.synthetic_scans import synthetic_scan
from scipy.spatial import cKDTree

import bodymeasure as bm
from bodymeasure.fit.model import atlas_of_vertices, body_model, limit_matrix
from bodymeasure.fit.solving.state import normals_of

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("number", range(8))
def test_a_random_scan_gives_the_true_body(number: int) -> None:
    scan = synthetic_scan(number)
    body = bm.fit_body((scan.vertices, scan.triangles), file_unit="m")
    truth = scan.truth @ body.transform[:3, :3].T + body.transform[:3, 3]
    inside = np.unique(body_model().quads[body_model().covered])
    points, surface = (limit_matrix() @ each for each in (body.vertices, truth))
    nearest = cKDTree(surface).query(points[inside])[1]
    steps = points[inside] - surface[nearest]
    gaps = np.einsum("nd,nd->n", steps, normals_of(surface)[nearest])
    # Carried landmarks are compared with carried ones; a rule may find others on either body.
    true, found = (atlas_of_vertices(each) for each in (truth, body.vertices))
    places = [np.linalg.norm(found.position(n) - true.position(n)) for n in true.landmarks]
    rms = float(np.sqrt(np.mean(gaps**2)))
    landmarks = float(np.sqrt(np.mean(np.square(places))))
    assert rms < 0.6e-3, (rms, landmarks)
    assert np.percentile(np.abs(gaps), 95) < 1.3e-3
    assert landmarks < 6e-3
    assert not len(body.uncovered)
