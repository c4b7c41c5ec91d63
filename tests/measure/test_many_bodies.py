"""The diagonals of many bodies in one call are those of each body."""

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.errors import InputError
from bodymeasure.measure.patches import many_bodies

NAMES = ("female_average", "male_average", "female_old")


@pytest.fixture(scope="module")
def nets() -> np.ndarray:
    return np.stack([bm.load_sample(name).control_points for name in NAMES])


@pytest.mark.parametrize("together", [1, 1504])
def test_they_are_those_of_each_body(
    together: int, nets: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(many_bodies, "TOGETHER", together)
    found = bm.diagonals_of_bodies(nets)
    assert found.length.shape == (3, 376, 2)
    assert repr(found).startswith("<DiagonalArrays of 3 bodies with 376 patches: 2,2")
    for place, name in enumerate(NAMES):
        alone = bm.diagonals(bm.load_sample(name), search="straight", on_failure="status")
        assert found.length[place] == pytest.approx(alone.length, rel=1e-12, nan_ok=True)
        assert (found.status[place] == alone.status).all()
        assert np.isfinite(found.error_estimate[place][np.isfinite(alone.length)]).all()


@pytest.mark.slow
def test_another_search_finds_those_along_edges(nets: np.ndarray) -> None:
    straight, every = (bm.diagonals_of_bodies(nets[:1], search=s) for s in ("straight", None))
    assert not np.isfinite(straight.length).all()
    assert np.isfinite(every.length).all()


@pytest.mark.parametrize("shape", [(376, 4, 4, 3), (2, 376, 4, 3, 3), (0, 376, 4, 4, 3)])
def test_other_shapes_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(InputError, match=r"expected \(bodies, patches, 4, 4, 3\)"):
        bm.diagonals_of_bodies(np.zeros(shape))
