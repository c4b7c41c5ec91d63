"""Cloth over the hollows of a body."""
