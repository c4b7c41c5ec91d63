"""A chart of body measurements, for people (``chart.html``) and for programs.

The programs read JSON and CSV, SeamlyMe and Seamly2D ``.smis``, FreeSewing its measurement sets,
and GarmentCode its files of bodies. Importing this package does not load jinja2; rendering a page
does.
"""

from bodymeasure.report.body.codes import FREESEWING_KEYS, GARMENTCODE_KEYS, check_codes
from bodymeasure.report.body.freesewing import asked_freesewing, missing_freesewing, to_freesewing
from bodymeasure.report.body.from_chart import body_record, chart_document
from bodymeasure.report.body.garmentcode import missing_garmentcode, to_garmentcode
from bodymeasure.report.body.outputs import OUTPUTS, write_chart
from bodymeasure.report.body.page import TapePictures, render_chart
from bodymeasure.report.body.records import BodyRecord, ChartDocument, chart_to_csv
from bodymeasure.report.body.scan_words import input_text, scan_sentences
from bodymeasure.report.body.smis import to_smis
from bodymeasure.report.body.tape import tailor_inches, tape_text
from bodymeasure.report.body.views import absences, gains, largest_shift, remarked

__all__ = [
    "FREESEWING_KEYS",
    "GARMENTCODE_KEYS",
    "OUTPUTS",
    "BodyRecord",
    "ChartDocument",
    "TapePictures",
    "absences",
    "asked_freesewing",
    "body_record",
    "chart_document",
    "chart_to_csv",
    "check_codes",
    "gains",
    "input_text",
    "largest_shift",
    "missing_freesewing",
    "missing_garmentcode",
    "remarked",
    "render_chart",
    "scan_sentences",
    "tailor_inches",
    "tape_text",
    "to_freesewing",
    "to_garmentcode",
    "to_smis",
    "write_chart",
]
