"""Measurements of the whole body: girths, drops, forks, straight distances."""
