"""The units of reports: their names, and how many decimals of a value are shown."""

from typing import Final, Literal

LengthUnit = Literal["m", "cm", "mm", "inch"]
ValueUnit = Literal["m", "cm", "mm", "inch", "deg"]
DEGREES: Final = "deg"

UNIT_NAMES = {"m": "meters", "cm": "centimeters", "mm": "millimeters", "inch": "inches"}

# Decimals by unit, from coarse to fine.
# A tape is read to a millimeter (0.01 inch is a quarter of one), an angle to a tenth of a degree.
TAPE_DECIMALS = {"m": 3, "cm": 1, "mm": 0, "inch": 2, "deg": 1}
# The tables of a report show a tenth of a millimeter (in inches, a quarter of a millimeter).
LENGTH_DECIMALS = {"m": 4, "cm": 2, "mm": 1, "inch": 2}
# Positions of landmarks and small distances are shown to a tenth of a millimeter or finer.
POSITION_DECIMALS = {"m": 4, "cm": 2, "mm": 1, "inch": 3}
# Files for pattern programs hold a hundredth of a millimeter or finer, and of a degree.
PATTERN_DECIMALS = {"cm": 3, "mm": 2, "inch": 4, "deg": 2}
# The list of diagonals shows a micrometer or finer.
FINE_DECIMALS = {"m": 6, "cm": 4, "mm": 3, "inch": 5}
