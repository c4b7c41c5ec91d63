"""Many small systems, some of them singular."""

import numpy as np

from bodymeasure.geodesic.numerics.linear_systems import solved


def test_a_singular_system_leaves_the_others_their_solutions(rng: np.random.Generator) -> None:
    matrix, known = rng.normal(size=(4, 3, 3)), rng.normal(size=(4, 3))
    matrix[2] = 0.0
    found = solved(matrix, (matrix @ known[..., None])[..., 0])
    assert np.isnan(found[2]).all()
    regular = [0, 1, 3]
    np.testing.assert_allclose(found[regular], known[regular], rtol=1e-10)
