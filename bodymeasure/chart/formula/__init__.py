"""Formulas of measurements: their parsing, the quantities that they give and their values."""
