"""Landmarks: the rules that derive them, their names and their symmetry."""
