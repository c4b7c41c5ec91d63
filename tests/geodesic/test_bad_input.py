"""Wrong arguments: each message names the argument, what was expected and the remedy."""

from typing import Any

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER

from bodymeasure import InputError
from bodymeasure.geodesic import WU_C10, RBFCollocation, solve_geodesic

ENDS = ((0.0, 0.0), (1.0, 1.0))


@pytest.mark.parametrize(
    ("surface", "message"),
    [
        (np.zeros(3), r"shape \(3,\); expected \(\.\.\., m \+ 1, n \+ 1, 3\)"),
        (np.zeros((16, 3)), r"shape \(16, 3\).*such as \(4, 4, 3\)"),
        (np.zeros((4, 4, 2)), r"shape \(4, 4, 2\)"),
        (np.zeros((1, 4, 3)), r"shape \(1, 4, 3\)"),
        (None, r"shape \(\)"),
        (np.full((4, 4, 3), 1.0j), "type ndarray is neither an array of real numbers"),
        ("cube.obj", "type str is neither an array of real numbers nor an object"),
        ([[1, 2], [3]], "type list is neither"),
        (object(), "type object is neither"),
        (np.full((4, 4, 3), 7.0), "patch 0 is degenerate: all its control points are equal; rem"),
        (np.where(np.eye(4)[..., None] > 0, np.nan, ENNEPER), "patch 0 has .* not finite"),
        (np.stack([ENNEPER, ENNEPER, np.zeros((4, 4, 3))]), "patch 2 is degenerate"),
    ],
)
def test_surfaces(surface: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        solve_geodesic(surface, *ENDS)


def test_infinite_control_points_name_the_patch() -> None:
    nets = np.stack([ENNEPER] * 4)
    nets[2, 1, 3, 0] = np.inf
    with pytest.raises(InputError, match="patch 2 has control points that are not finite"):
        solve_geodesic(nets, *ENDS)


@pytest.mark.parametrize(
    ("point", "message"),
    [
        (0.5, r"shape \(\); expected \(\.\.\., 2\): u and v"),
        ((0.1, 0.2, 0.3), r"shape \(3,\)"),
        (np.zeros((2, 2, 1)), r"shape \(2, 2, 1\)"),
        ((0.5, 1.0 + 1e-12), r"expected u and v in \[0, 1\]"),
        ((-1e-12, 0.5), r"expected u and v in \[0, 1\]"),
        ((np.nan, 0.5), r"holds \[nan, 0\.5\]; expected"),
        ((0.5, np.inf), r"holds \[0\.5, inf\]"),
        ([(0.1, 0.1), (0.2, 7.0)], r"holds \[0\.2, 7\.0\]"),
        (("a", "b"), "expected numbers"),
        ([(0.1, 0.2), (0.3,)], "expected numbers"),
    ],
)
@pytest.mark.parametrize("which", ["start", "end"])
def test_points(point: Any, message: str, which: str) -> None:
    given = {"start": ENDS[0], "end": ENDS[1], which: point}
    with pytest.raises(InputError, match=f"^{which} .*{message}"):
        solve_geodesic(ENNEPER, **given)


def test_shapes_that_do_not_broadcast() -> None:
    with pytest.raises(InputError, match=r"\(3,\), \(2,\), \(\) of surface, start and end"):
        solve_geodesic(np.stack([ENNEPER] * 3), np.zeros((2, 2)), (1.0, 1.0))


def test_on_failure_is_one_of_two() -> None:
    with pytest.raises(InputError, match="on_failure is 'ignore'; expected 'raise' or 'status'"):
        solve_geodesic(ENNEPER, *ENDS, on_failure="ignore")  # type: ignore[arg-type]


def test_words_are_words() -> None:
    words: Any = np.array(["quick", "straight"])
    with pytest.raises(InputError, match=r"search is array.*; expected one of quick"):
        solve_geodesic(ENNEPER, *ENDS, search=words)
    with pytest.raises(InputError, match=r"on_failure is array.*; expected 'raise' or 'status'"):
        solve_geodesic(ENNEPER, *ENDS, on_failure=words)


@pytest.mark.parametrize("method", [42, "rbf", RBFCollocation, 0.0])
def test_a_method_is_one_with_its_settings(method: Any) -> None:
    with pytest.raises(InputError, match=r"^method is .*; expected .* such as RBFCollocation\(\)"):
        solve_geodesic(ENNEPER, *ENDS, method=method)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"support_radius": "two"}, "support_radius is 'two'; expected a positive number"),
        ({"support_radius": (1.0, 2.0)}, r"support_radius is \(1\.0, 2\.0\)"),
        ({"tolerance": None}, "tolerance is None; expected a positive number"),
        ({"tolerance": np.array([1e-3, 1e-4])}, "tolerance is array"),
        ({"tolerance": np.inf}, "tolerance is inf"),
        ({"functions": True}, "functions is True"),
        ({"support_radius": 0.0}, "support_radius is 0.0; expected a positive number"),
        ({"support_radius": -1.0}, "support_radius is -1.0"),
        ({"support_radius": np.nan}, "support_radius is nan"),
        ({"support_radius": np.inf}, "support_radius is inf"),
        ({"tolerance": 0.0}, "tolerance is 0.0; expected a positive number"),
        ({"tolerance": -1e-9}, "tolerance"),
        ({"tolerance": np.nan}, "tolerance is nan"),
        ({"functions": (8, 41)}, "41 functions are asked for; expected at most 40"),
        ({"centers": tuple(range(99))}, "99 functions are asked for"),
        ({"functions": 0}, "functions is 0; expected a whole number of at least 1"),
        ({"functions": -4}, "functions is -4"),
        ({"functions": ()}, r"functions is \(\)"),
        ({"functions": (8, 0)}, r"functions is \(8, 0\)"),
        ({"functions": 8.0}, r"functions is 8\.0.*a whole number"),
        ({"functions": (8, 8.5)}, "functions"),
        ({"functions": "many"}, "functions is 'many'"),
        ({"centers": ()}, "centers is .*expected finite numbers, at least one"),
        ({"centers": (0.1, np.nan)}, "centers is .*expected finite numbers"),
        ({"centers": (0.1, np.inf)}, "centers is .*expected finite numbers"),
        ({"centers": 0.5}, "centers is 0.5; expected a sequence of numbers"),
        ({"centers": [[0.1, 0.2], [0.3, 0.4]]}, "centers is .* expected a sequence"),
        ({"centers": "ab"}, "centers is 'ab'"),
        ({"kernel": "Wu C2"}, "kernel is 'Wu C2'; expected a Kernel, such as WU_C2"),
        ({"functions": 3, "collocation_points": (0.5,)}, "1 collocation points for 3 functions"),
        ({"collocation_points": (0.5,)}, "for 8, 12, 16, 20 functions; expected one fewer"),
        ({"centers": (1.0, 1.5), "collocation_points": (0.2, 0.5)}, "2 collocation points for 2"),
        ({"functions": 3, "collocation_points": (0.5, 0.5)}, "increase, strictly between 0 and 1"),
        ({"functions": 3, "collocation_points": (0.7, 0.5)}, "increase"),
        ({"functions": 3, "collocation_points": (0.0, 0.5)}, "strictly between"),
        ({"functions": 3, "collocation_points": (0.5, 1.0)}, "strictly between"),
        ({"functions": 3, "collocation_points": (0.5, np.nan)}, "increase"),
        ({"functions": 2, "collocation_points": 0.5}, "collocation_points is 0.5"),
    ],
)
def test_settings(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        RBFCollocation(**settings)


@pytest.mark.parametrize(
    "settings",
    [
        {"centers": (0.3, 0.3, 0.8)},
        {"centers": (0.3, 0.5, 8.0)},
        {"functions": 8, "support_radius": 1e-3},
    ],
)
def test_settings_that_prove_degenerate_when_they_are_used(settings: dict[str, Any]) -> None:
    method = RBFCollocation(**settings)
    with pytest.raises(InputError, match="degenerate"):
        solve_geodesic(ENNEPER, *ENDS, method=method)


@pytest.mark.parametrize(
    "settings",
    [
        {"functions": 8},
        {"functions": [6, 9]},
        {"functions": np.int64(8)},
        {"functions": np.array([8, 12])},
        {"functions": (12, 8, 12)},
        {"functions": (8, 8)},
        {"centers": np.array([-0.6, -0.3, -0.1, 1.1, 1.3, 1.6, 1.8])},
        {"centers": [-1, -0.5, 0, 1, 1.5, 2, -0.25]},
        {"functions": 8, "collocation_points": (0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95)},
        {"support_radius": 4},
        {"support_radius": 40.0},
    ],
)
def test_settings_of_all_kinds_give_the_length(settings: dict[str, Any]) -> None:
    method = RBFCollocation(WU_C10, tolerance=1e-7, **settings)
    solution = solve_geodesic(ENNEPER, (0.1, 0.0), (1.0, 0.6), method=method)
    exact = solve_geodesic(ENNEPER, (0.1, 0.0), (1.0, 0.6)).length
    assert abs(solution.length - exact) <= solution.error_estimate + 1e-14 < 1e-6
    assert solution.path([0.0, 1.0]) == pytest.approx(np.array([[0.1, 0.0], [1.0, 0.6]]))
    listed = np.concatenate([batch.problems for batch in solution.batches])
    assert listed.tolist() == [0]


def test_the_same_settings_are_the_same_method() -> None:
    assert RBFCollocation() == RBFCollocation()
    assert RBFCollocation(functions=8) != RBFCollocation()
    assert "Wu C10" in str(RBFCollocation())
