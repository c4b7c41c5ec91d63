"""Girths, and parts of them."""
