from collections.abc import Iterator
from dataclasses import fields

import numpy as np
import pytest
from helpers.surfaces.random_patches import wild_patches

from bodymeasure._typing import Array
from bodymeasure.paper.data import comparison
from bodymeasure.paper.data.comparison import Comparison, compare
from bodymeasure.paper.data.truth import true_diagonals
from bodymeasure.paper.method.ritz_table import solve_ritz
from bodymeasure.paper.method.two_function_solve import solve_two_functions
from bodymeasure.paper.tables.scaling import (
    measure_scaling,
    same_to_the_bit,
    scaling_table,
    solve_distributed,
)

TIMES = {"rbf_seconds", "ritz_seconds"}


@pytest.fixture(scope="module")
def nets() -> Iterator[Array]:
    """Enough patches for several parts."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(comparison, "CHUNK", 2)
        yield wild_patches(np.random.default_rng(4), 3, 1.0)


@pytest.fixture(scope="module")
def found(nets: Array) -> Comparison:
    return compare(nets, processes=2)


@pytest.mark.slow
def test_what_is_found_does_not_depend_on_the_number_of_processes(
    nets: Array, found: Comparison
) -> None:
    done: list[int] = []
    one = compare(nets, processes=1, progress=done.append)
    assert done == [2, 3]
    assert len(one) == len(nets)
    for field in fields(Comparison):
        here, there = getattr(one, field.name), getattr(found, field.name)
        assert len(here) == len(nets)
        if field.name not in TIMES:
            np.testing.assert_array_equal(here, there, strict=True)
        else:
            assert (here > 0.0).all()


@pytest.mark.slow
def test_it_is_what_the_methods_find(nets: Array, found: Comparison) -> None:
    inside, every = (solve_two_functions(nets, rule) for rule in ("inside", "all"))
    np.testing.assert_allclose(found.inside_length, inside.length, rtol=1e-9)
    np.testing.assert_allclose(found.all_length, every.length, rtol=1e-9)
    np.testing.assert_array_equal(found.roots, every.roots)
    np.testing.assert_allclose(found.ritz_length, solve_ritz(nets).length, rtol=1e-9)
    np.testing.assert_allclose(found.true_length, true_diagonals(nets).length, rtol=1e-9)


@pytest.mark.slow
def test_distributed_collocation_is_the_same_to_the_bit(nets: Array) -> None:
    runs = measure_scaling(nets, (1, 2), with_start=False)
    assert same_to_the_bit(runs[0].solution, runs[1].solution)
    other = solve_distributed(nets[::-1].copy(), 2)
    assert not same_to_the_bit(runs[0].solution, other)
    table = scaling_table(runs)
    names = [column.name for column in table.columns]
    for row, processes in zip(table.rows, (1, 2), strict=True):
        told = dict(zip(names, row, strict=True))
        assert (told["processes"], told["patches"], told["identical"]) == (processes, 3, True)
        assert told["start_seconds"] is None
