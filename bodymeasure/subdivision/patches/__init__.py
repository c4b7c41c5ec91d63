"""Bicubic patches of Catmull-Clark surfaces, and how far they deviate."""
