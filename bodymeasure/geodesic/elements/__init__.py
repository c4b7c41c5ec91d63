"""Paths made of many short polynomials, for those that a single polynomial does not serve."""
