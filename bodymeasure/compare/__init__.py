"""Comparison of body measurements from two sources: differences and verdicts of ISO 20685-1."""

from bodymeasure.compare.comparison import compare
from bodymeasure.compare.iso20685 import MINIMUM_SUBJECTS
from bodymeasure.compare.names import Known, known_from
from bodymeasure.compare.page import render_comparison
from bodymeasure.compare.read import read_readings
from bodymeasure.compare.readings import Reading, Readings, readings_of, readings_of_subjects
from bodymeasure.compare.records import VERDICTS, Comparison, comparison_to_csv

__all__ = [
    "MINIMUM_SUBJECTS",
    "VERDICTS",
    "Comparison",
    "Known",
    "Reading",
    "Readings",
    "compare",
    "comparison_to_csv",
    "known_from",
    "read_readings",
    "readings_of",
    "readings_of_subjects",
    "render_comparison",
]
