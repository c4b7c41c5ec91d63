"""Paths and closed paths across the patches of an atlas."""
