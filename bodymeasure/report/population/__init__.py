"""Charts of several bodies together: one row for each subject, and summaries."""

from bodymeasure.report.population.document import population_document
from bodymeasure.report.population.outputs import write_population_chart
from bodymeasure.report.population.page import render_population
from bodymeasure.report.population.records import PopulationDocument
from bodymeasure.report.population.tables import long_csv, wide_csv

__all__ = [
    "PopulationDocument",
    "long_csv",
    "population_document",
    "render_population",
    "wide_csv",
    "write_population_chart",
]
