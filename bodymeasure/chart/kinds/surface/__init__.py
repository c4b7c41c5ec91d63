"""Measurements along the surface."""
