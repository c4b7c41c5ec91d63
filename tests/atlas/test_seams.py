import numpy as np
from helpers.surfaces.grids import grid_index

from bodymeasure.atlas import EDGES, edge_table


def test_sides_lie_where_their_names_say() -> None:
    index = np.arange(16).reshape(1, 4, 4)
    sides = dict(
        zip((edge.name for edge in EDGES), edge_table(index).control_index[0], strict=True)
    )
    assert {name: side.tolist() for name, side in sides.items()} == {
        "u = 0": [0, 1, 2, 3],
        "u = 1": [12, 13, 14, 15],
        "v = 0": [0, 4, 8, 12],
        "v = 1": [3, 7, 11, 15],
    }


def test_a_grid_has_its_seams_and_boundary() -> None:
    rows, columns = 3, 4
    table = edge_table(grid_index(rows, columns))
    assert np.count_nonzero(table.sides == 1) == 2 * (rows + columns)
    assert np.count_nonzero(table.sides == 2) == rows * (columns - 1) + columns * (rows - 1)
    assert len(table.sides) == table.edge.max() + 1
    # Patches 0 and 1 share v = 1 and v = 0, patches 0 and 4 share u = 1 and u = 0.
    assert table.edge[0, 3] == table.edge[1, 2]
    assert table.edge[0, 1] == table.edge[4, 0]


def test_neighbors_in_any_position_share_one_edge(rng: np.random.Generator) -> None:
    index = grid_index(2, 1)
    numbers = rng.permutation(index.max() + 1)
    index = numbers[index]
    for turns in range(4):
        for mirrored in (False, True):
            neighbor = np.rot90(index[1], turns)
            neighbor = neighbor.T if mirrored else neighbor
            table = edge_table(np.stack([index[0], neighbor]))
            assert sorted(table.sides) == [1] * 6 + [2]
            shared = np.argwhere(table.sides[table.edge] == 2)
            assert shared[0].tolist() == [0, 1]
            first, second = (table.control_index[tuple(side)] for side in shared)
            reversed_ = [bool(table.reversed[tuple(side)]) for side in shared]
            ahead = reversed_[0] == reversed_[1]
            np.testing.assert_array_equal(first, second if ahead else second[::-1])


def test_every_side_beyond_two_is_counted() -> None:
    first, second = grid_index(2, 1)
    third = second.copy()
    third[1:] += 100
    fourth = second.copy()
    fourth[1:] += 200
    table = edge_table(np.stack([first, second, third, fourth[::-1]]))
    assert sorted(table.sides)[-1] == 4
