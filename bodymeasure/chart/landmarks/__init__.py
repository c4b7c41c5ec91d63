"""Landmarks: rules that derive them, their names, picks, and symmetry."""
