"""Measurements of a whole body, beside what libraries measure on its triangle meshes."""
