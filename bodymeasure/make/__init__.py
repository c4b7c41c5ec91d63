"""Bodies made to measure: some tapes go in, the most plausible body that has them comes out."""

from bodymeasure.make.body.prior import Prior
from bodymeasure.make.grade import grade_body, make_sizes
from bodymeasure.make.input import Measurements, Value, read_measurements
from bodymeasure.make.make import make_body
from bodymeasure.make.result import Asked, MadeBody, Predicted

__all__ = [
    "Asked",
    "MadeBody",
    "Measurements",
    "Predicted",
    "Prior",
    "Value",
    "grade_body",
    "make_body",
    "make_sizes",
    "read_measurements",
]
