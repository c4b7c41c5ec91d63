"""Paths across patches, piece by piece: unknowns, refinement, error and result."""
