"""What a survey or a chart found, for people (HTML pages) and for programs (JSON, CSV).

Importing this package does not load jinja2; rendering a page does. What writes charts, with all
that charts need, is loaded when it is first asked for: tables of diagonals do without.
"""

from typing import TYPE_CHECKING

from bodymeasure.lazy import loader
from bodymeasure.report.patches.from_survey import measurement_records, survey_document
from bodymeasure.report.patches.outputs import write_report
from bodymeasure.report.patches.page import Pictures, render_html
from bodymeasure.report.patches.ranking import closeup_patches, disagreements
from bodymeasure.report.patches.records import Document, PatchRecord, to_csv
from bodymeasure.report.serial import json_schema, to_json

__all__ = [
    "Document",
    "PatchRecord",
    "Pictures",
    "closeup_patches",
    "disagreements",
    "json_schema",
    "measurement_records",
    "render_html",
    "survey_document",
    "to_csv",
    "to_json",
    "write_chart",
    "write_report",
]

if TYPE_CHECKING:
    from bodymeasure.report.body.outputs import write_chart
else:
    __getattr__ = loader(__name__, __all__, ("body.outputs",))
