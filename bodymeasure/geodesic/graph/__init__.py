"""Paths as graphs over their straight line, with one unknown function."""
