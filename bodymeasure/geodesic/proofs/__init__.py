"""Proofs: that a path is the shortest on its patch, and bounds of lengths that hold by theorem."""
