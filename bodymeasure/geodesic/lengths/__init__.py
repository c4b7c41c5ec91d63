"""The length of a path, its error estimate, and whether it is a local minimum."""
