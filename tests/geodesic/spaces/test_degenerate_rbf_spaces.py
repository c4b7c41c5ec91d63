"""Radial functions whose collocation system is singular or nearly so."""

import numpy as np
import pytest

from bodymeasure import InputError
from bodymeasure.geodesic import WU_C2, WU_C6, Kernel, RBFCollocation
from bodymeasure.geodesic.methods.rbf_collocation import (
    chebyshev_points,
    default_centers,
)
from bodymeasure.geodesic.spaces.rbf import rbf_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

POINTS = np.concatenate([np.linspace(0.0, 1.0, 33), [1e-12, 0.349999, 0.35, 0.350001]])


def space(kernel: Kernel, centers: tuple[float, ...], radius: float) -> TrialSpace:
    return rbf_space(kernel, centers, tuple(chebyshev_points(len(centers) - 1)), radius)


def test_symmetric_points_of_an_odd_number_of_functions_are_moved() -> None:
    # All functions and the constant but one are then symmetric about 1/2 in pairs, and the
    # collocation points see one combination of them as zero: the paper's section 5.
    trial = space(WU_C2, tuple(default_centers(WU_C2, 9)), 2.0)
    assert "moved" in trial.description
    assert np.abs(trial.nodes[1:-1] - chebyshev_points(8)).max() > 0.01
    assert (np.diff(trial.nodes) > 0.0).all()
    even = space(WU_C2, tuple(default_centers(WU_C2, 8)), 2.0)
    assert "moved" not in even.description
    np.testing.assert_array_equal(even.nodes[1:-1], chebyshev_points(7))
    assert even.description == "8 Wu C2 functions"


@pytest.mark.parametrize(
    "count", [pytest.param(count, marks=pytest.mark.slow) for count in (34, 40)]
)
def test_too_many_functions_are_refused_for_what_they_do_to_rounding_errors(count: int) -> None:
    with pytest.raises(InputError, match=r"rounding errors would grow .*choose fewer functions"):
        list(RBFCollocation(functions=count).spaces)
    # This is the remedy that the message names.
    for better in (RBFCollocation(functions=30), RBFCollocation(functions=count, support_radius=1)):
        assert len(list(better.spaces)) == 1


@pytest.mark.parametrize(
    ("centers", "radius"),
    [
        ((0.2, 0.2, 0.8), 2.0),  # two alike
        ((0.2, 0.5, 9.0), 2.0),  # one that does not reach [0, 1]
        ((-2.0, 0.5, 0.9), 2.0),  # one that ends just at 0
        ((0.1, 0.2, 0.3, 0.4), 0.01),  # supports that miss the nodes
        (
            (0.1, 0.2, 0.4, 0.6, 0.7, 0.9),
            1e12,
        ),  # a support so wide that the functions are constant to 60 digits
    ],
)
def test_degenerate_centers_are_refused(centers: tuple[float, ...], radius: float) -> None:
    with pytest.raises(InputError, match=r"degenerate.*choose other centers") as caught:
        space(WU_C2, centers, radius)
    assert f"{len(centers)} Wu C2" in str(caught.value)


def test_two_centers_that_nearly_coincide_still_give_a_right_space() -> None:
    # Their difference is nearly a derivative of the kernel: a bad basis of a good space.
    trial = space(WU_C6, (-0.2, 0.4, 0.4 + 1e-6, 1.2), 2.0)
    assert trial.condition > 1e5
    assert np.abs(trial.matrices(POINTS)[0]).sum(axis=1).max() < 100.0
    np.testing.assert_allclose(
        trial.matrices(trial.nodes)[0], np.eye(len(trial.nodes)), rtol=0.0, atol=1e-13
    )
