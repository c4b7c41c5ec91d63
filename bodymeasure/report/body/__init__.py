"""A chart of body measurements, for people (``chart.html``) and programs.

JSON and CSV, SeamlyMe's ``.smis`` and FreeSewing's measurement sets. Importing this does not load
jinja2; rendering a page does.
"""

from bodymeasure.report.body.codes import FREESEWING_KEYS, check_codes
from bodymeasure.report.body.freesewing import missing_freesewing, to_freesewing
from bodymeasure.report.body.from_chart import chart_document
from bodymeasure.report.body.page import TapePictures, render_chart
from bodymeasure.report.body.records import (
    BodyMeasurement,
    ChartDocument,
    chart_schema,
    chart_to_csv,
    chart_to_json,
)
from bodymeasure.report.body.smis import to_smis
from bodymeasure.report.body.tape import tailor_inches, tape_text
from bodymeasure.report.body.write import write_chart

__all__ = [
    "FREESEWING_KEYS",
    "BodyMeasurement",
    "ChartDocument",
    "TapePictures",
    "chart_document",
    "chart_schema",
    "chart_to_csv",
    "chart_to_json",
    "check_codes",
    "missing_freesewing",
    "render_chart",
    "tailor_inches",
    "tape_text",
    "to_freesewing",
    "to_smis",
    "write_chart",
]
