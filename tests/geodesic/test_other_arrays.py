"""Control points from another array library, at the only function that takes them."""

import numpy as np
import pytest
from benchmarks.independent import reference

import bodymeasure as bm
from bodymeasure._typing import Array

torch = pytest.importorskip("torch")


@pytest.fixture
def nets(rng: np.random.Generator) -> Array:
    # Some patches are wild, too: these go on to the search, which works with numpy's arrays.
    mild = reference.mild_patches(rng, 12, 0.3)
    return np.concatenate([7.0 * mild, reference.wild_patches(rng, 4, 1.0)])


def test_a_tensor_has_the_lengths_of_its_numbers(nets: Array) -> None:
    start = (0.0, 0.0)
    end = np.array([[1.0, 1.0], [0.9, 0.7]])
    mine = bm.solve_geodesic(nets[:, None], start, end, on_failure="status")
    theirs = bm.solve_geodesic(torch.from_numpy(nets[:, None]), start, end, on_failure="status")
    assert type(theirs.length) is np.ndarray
    np.testing.assert_array_equal(theirs.status, mine.status)
    np.testing.assert_allclose(theirs.length, mine.length, rtol=1e-10)
    easy = slice(0, 12)
    np.testing.assert_allclose(theirs.length[easy], mine.length[easy], rtol=1e-13)
    np.testing.assert_allclose(theirs.path(0.3)[easy], mine.path(0.3)[easy], atol=1e-9)


def test_a_tensor_that_keeps_a_record_is_taken_and_left_alone(nets: Array) -> None:
    tensor = torch.from_numpy(nets[0].copy()).requires_grad_()
    length = bm.solve_geodesic(tensor, (0.0, 0.0), (1.0, 1.0)).length
    assert length == pytest.approx(bm.solve_geodesic(nets[0], (0.0, 0.0), (1.0, 1.0)).length)
    np.testing.assert_array_equal(tensor.detach().numpy(), nets[0])
    start = torch.zeros(2).requires_grad_()
    assert bm.solve_geodesic(nets[0], start, (1.0, 1.0)).length == pytest.approx(length)


def test_single_precision_is_taken_for_what_it_says(nets: Array) -> None:
    single = torch.from_numpy(nets[0]).to(torch.float32)
    expected = bm.solve_geodesic(nets[0].astype(np.float32), (0.0, 0.0), (1.0, 1.0)).length
    assert bm.solve_geodesic(single, (0.0, 0.0), (1.0, 1.0)).length == pytest.approx(expected)


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda t: t.to(torch.complex128), "neither an array of real numbers"),
        (lambda t: t[..., :2], r"shape \(4, 4, 2\); expected"),
        (lambda t: t / 0.0, "patch 0 has control points that are not finite"),
        (lambda t: 0.0 * t, "patch 0 is degenerate"),
    ],
)
def test_a_bad_tensor_is_refused(nets: Array, spoil: object, message: str) -> None:
    with pytest.raises(bm.InputError, match=message):
        bm.solve_geodesic(spoil(torch.from_numpy(nets[0])), (0.0, 0.0), (1.0, 1.0))  # type: ignore[operator]
