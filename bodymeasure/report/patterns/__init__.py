"""The page of a pattern."""

from bodymeasure.report.patterns.page import BodyPictures, render_pattern

__all__ = ["BodyPictures", "render_pattern"]
