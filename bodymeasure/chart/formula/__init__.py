"""Formulas of measurements: parsing, quantities, values, checks."""
