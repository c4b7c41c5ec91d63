"""Tables of sizes from a survey: which sizes a population needs, and whom each fits."""

from bodymeasure.surveys.sizes.schemes import MedoidSizes, SizeScheme, StepSizes
from bodymeasure.surveys.sizes.sizes import Control, Size, SizeTable, size_table
from bodymeasure.surveys.sizes.write import write_sizes

__all__ = [
    "Control",
    "MedoidSizes",
    "Size",
    "SizeScheme",
    "SizeTable",
    "StepSizes",
    "size_table",
    "write_sizes",
]
