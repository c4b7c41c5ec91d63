"""Closest, outermost and farthest points of an atlas, and its outside."""
