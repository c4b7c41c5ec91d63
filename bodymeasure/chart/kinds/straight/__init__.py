"""Measurements along straight lines."""
