"""The bodies of a survey: files, atlases, and the rows of a file of many bodies."""

from bodymeasure.surveys.bodies.files import file_bodies
from bodymeasure.surveys.bodies.held import HeldAtlases, extremity_keys
from bodymeasure.surveys.bodies.population import is_population, open_population
from bodymeasure.surveys.bodies.surveyed import Asked, Bodies, Body, Layout

__all__ = [
    "Asked",
    "Bodies",
    "Body",
    "HeldAtlases",
    "Layout",
    "extremity_keys",
    "file_bodies",
    "is_population",
    "open_population",
]
