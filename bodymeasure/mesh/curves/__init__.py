"""Paths as curves in files of CAD programs."""
