"""Commands that measure: diagonals, report, chart, compare."""
