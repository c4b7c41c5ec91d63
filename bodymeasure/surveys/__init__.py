"""Surveys of many bodies: one table of all charts, in processes or on a cluster, and what it says.

`survey` measures, `read_survey` opens the table again, and `write_survey` makes the page.
`size_table` makes sizes of it.
"""

from bodymeasure.surveys.page import write_survey
from bodymeasure.surveys.records import Column, Failed, SurveyTable, read_survey
from bodymeasure.surveys.sizes import (
    Control,
    MedoidSizes,
    Size,
    SizeScheme,
    SizeTable,
    StepSizes,
    size_table,
    write_sizes,
)
from bodymeasure.surveys.take import survey

__all__ = [
    "Column",
    "Control",
    "Failed",
    "MedoidSizes",
    "Size",
    "SizeScheme",
    "SizeTable",
    "StepSizes",
    "SurveyTable",
    "read_survey",
    "size_table",
    "survey",
    "write_sizes",
    "write_survey",
]
