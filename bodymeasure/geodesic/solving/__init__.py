"""Solving the geodesic equations in a trial space, for all problems of a batch."""
