"""The part of a body inside a closed chain of curves, as a mesh."""
