"""Shortest paths that run along edges of their patch for a part."""
