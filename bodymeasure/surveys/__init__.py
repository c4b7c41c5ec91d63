"""Surveys of many bodies: one table of all charts, in processes or on a cluster, and what it says.

`survey` measures, `read_survey` opens the table again, and `write_survey` makes the page.
"""

from bodymeasure.surveys.page import write_survey
from bodymeasure.surveys.records import Column, Failed, SurveyTable, read_survey
from bodymeasure.surveys.survey import survey

__all__ = [
    "Column",
    "Failed",
    "SurveyTable",
    "read_survey",
    "survey",
    "write_survey",
]
