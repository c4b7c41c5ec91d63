"""Paths past collapsed sides: through a pole, close by it, and from points beside it."""
