"""The page of a pattern, and its files."""

from bodymeasure.report.patterns.outputs import (
    checked_formats,
    pattern_files,
    write_pattern,
)
from bodymeasure.report.patterns.page import BodyPictures, render_pattern

__all__ = [
    "BodyPictures",
    "checked_formats",
    "pattern_files",
    "render_pattern",
    "write_pattern",
]
