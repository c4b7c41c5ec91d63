"""A chart of body measurements: definitions as data, landmarks by rule, results with statuses."""

from bodymeasure.chart.accuracy import AccuracyClass, accuracy_class
from bodymeasure.chart.definitions import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    Definitions,
    DepthMeasure,
    DropMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthMeasure,
    HeightMeasure,
    Iso,
    LimbGirthMeasure,
    Measurement,
    PathMeasure,
)
from bodymeasure.chart.derive import Derived, derive_landmarks
from bodymeasure.chart.measured import Chart, Measured, Outcome, Tape, TapeKind

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
    "GirthMeasure",
    "HeightMeasure",
    "Iso",
    "LimbGirthMeasure",
    "Measured",
    "Measurement",
    "Outcome",
    "PathMeasure",
    "Tape",
    "TapeKind",
    "accuracy_class",
    "derive_landmarks",
]
