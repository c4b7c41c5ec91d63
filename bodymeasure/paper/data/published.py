"""The figures that the paper prints, which stand beside ours."""

from dataclasses import dataclass

# Table 3: length and seconds by radial functions, length and seconds by Ritz.
TABLE_3 = (
    (1.57495, 0.141, 1.56924, 0.125),
    (1.37739, 0.141, 1.37116, 0.110),
    (1.41368, 0.125, 1.40248, 0.109),
    (1.59956, 0.140, 1.59710, 0.125),
)
# Table 4: mean accuracy loss and mean time improved of each set, as ratios.
TABLE_4 = ((0.0289, 1.01), (0.0301, 1.01), (0.0322, 0.98), (0.0317, 1.05))
MEAN_LOSS = sum(loss for loss, _ in TABLE_4) / len(TABLE_4)
SECONDS_BY_RITZ = max(row[3] for row in TABLE_3)
LENGTHS = tuple(row[2] for row in TABLE_3)


@dataclass(frozen=True)
class Table5Row:
    """A row of Table 5: lengths in cm, and the relative error as it is printed, as a ratio."""

    calculated: float
    physical: float
    relative_error: float


TABLE_5 = (
    Table5Row(13.1038, 13.0, -0.008),
    Table5Row(6.18354, 6.25, 0.0106),
    Table5Row(10.2788, 10.25, -0.0028),
    Table5Row(8.84254, 8.75, 0.0106),
)
