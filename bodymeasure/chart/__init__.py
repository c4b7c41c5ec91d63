"""A chart of body measurements: definitions as data, landmarks by rule, results with statuses.

The kinds of measurements are in `bodymeasure.chart.kinds`, and the rules for landmarks are in
`bodymeasure.chart.landmarks.rules`.
"""

from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.chart import Chart
from bodymeasure.chart.definitions import Definitions, definitions_schema
from bodymeasure.chart.evaluate import measure_chart
from bodymeasure.chart.found import FoundLandmarks, found_landmarks
from bodymeasure.chart.kinds.base import Iso, Measured, MeasurementDefinition, Outcome, Shift
from bodymeasure.chart.landmarks.derive import Derived, derive_landmarks
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.needed import Lacking, Pick, lacking, names_in, worth_picking
from bodymeasure.chart.reading.guide import default_set
from bodymeasure.chart.reading.read import load_definitions
from bodymeasure.chart.selection import restricted, selected_keys
from bodymeasure.chart.sides import both_sides
from bodymeasure.chart.tapes import Tape, TapeKind

__all__ = [
    "AccuracyClass",
    "Chart",
    "Definitions",
    "Derived",
    "FoundLandmarks",
    "Iso",
    "Lacking",
    "LandmarkRule",
    "Measured",
    "MeasurementDefinition",
    "Outcome",
    "Pick",
    "Shift",
    "Tape",
    "TapeKind",
    "both_sides",
    "default_set",
    "definitions_schema",
    "derive_landmarks",
    "found_landmarks",
    "lacking",
    "load_definitions",
    "measure_chart",
    "names_in",
    "restricted",
    "selected_keys",
    "worth_picking",
]
