"""The report of a survey: records, rankings, the page."""
