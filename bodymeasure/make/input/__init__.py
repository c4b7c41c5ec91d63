"""Measurements that a body is to have: read from files, and named as the definitions do."""

from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.read import read_measurements

__all__ = ["Measurements", "Value", "read_measurements"]
