"""Definitions of pieces as data."""
