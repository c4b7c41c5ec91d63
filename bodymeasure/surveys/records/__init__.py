"""The records of a survey: a row for each body, and the table of all rows."""

from bodymeasure.surveys.records.columns import MEMBERS, Column, columns_of
from bodymeasure.surveys.records.measured import Charting, measured_row
from bodymeasure.surveys.records.row import Lack, Row, rows_from_bytes, rows_to_bytes
from bodymeasure.surveys.records.table import (
    Failed,
    SurveyTable,
    read_survey,
    require_pyarrow,
    write_table,
)

__all__ = [
    "MEMBERS",
    "Charting",
    "Column",
    "Failed",
    "Lack",
    "Row",
    "SurveyTable",
    "columns_of",
    "measured_row",
    "read_survey",
    "require_pyarrow",
    "rows_from_bytes",
    "rows_to_bytes",
    "write_table",
]
