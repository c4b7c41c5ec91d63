"""Flat pieces of panels, and sets of them."""
