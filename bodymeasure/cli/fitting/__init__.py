"""Fitting bodies to scans: the command `fit`, and what other commands need of it."""
