"""A chart of body measurements: definitions as data, landmarks by rule, results with statuses."""

from bodymeasure.chart.accuracy import AccuracyClass, accuracy_class
from bodymeasure.chart.chart import Chart, Measured, Outcome, Tape, TapeKind
from bodymeasure.chart.evaluate import measure_chart
from bodymeasure.chart.kinds.definitions import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    Definitions,
    DepthMeasure,
    DropMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthArcMeasure,
    GirthMeasure,
    HeightMeasure,
    Iso,
    LimbGirthMeasure,
    Measurement,
    OverMeasure,
    PathMeasure,
    TiltedGirthMeasure,
    definitions_schema,
)
from bodymeasure.chart.landmarks.derive import Derived, derive_landmarks
from bodymeasure.chart.reading.read import default_set, load_definitions
from bodymeasure.chart.reading.sides import both_sides

__all__ = [
    "AccuracyClass",
    "BreadthMeasure",
    "Chart",
    "ChordMeasure",
    "ClosedMeasure",
    "Definitions",
    "DepthMeasure",
    "Derived",
    "DropMeasure",
    "ExtremeGirthMeasure",
    "FormulaMeasure",
    "GirthArcMeasure",
    "GirthMeasure",
    "HeightMeasure",
    "Iso",
    "LimbGirthMeasure",
    "Measured",
    "Measurement",
    "Outcome",
    "OverMeasure",
    "PathMeasure",
    "Tape",
    "TapeKind",
    "TiltedGirthMeasure",
    "accuracy_class",
    "both_sides",
    "default_set",
    "definitions_schema",
    "derive_landmarks",
    "load_definitions",
    "measure_chart",
]
