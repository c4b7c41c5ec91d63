"""The page of a survey and the tables beside it."""

from bodymeasure.surveys.page.write import write_survey

__all__ = ["write_survey"]
