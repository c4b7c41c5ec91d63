"""Measurements of every patch: diagonals, boundary curves, the cross-check."""
