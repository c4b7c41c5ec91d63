"""What a survey found, for people (``report.html``) and programs (JSON, CSV).

Importing this does not load jinja2; rendering a page does.
"""

from bodymeasure.report.patches.from_survey import measurement_records, survey_document
from bodymeasure.report.patches.page import Pictures, render_html
from bodymeasure.report.patches.ranking import closeup_patches, disagreements
from bodymeasure.report.patches.records import (
    Document,
    Measurement,
    json_schema,
    to_csv,
    to_json,
)
from bodymeasure.report.patches.write import write_report

__all__ = [
    "Document",
    "Measurement",
    "Pictures",
    "closeup_patches",
    "disagreements",
    "json_schema",
    "measurement_records",
    "render_html",
    "survey_document",
    "to_csv",
    "to_json",
    "write_report",
]
