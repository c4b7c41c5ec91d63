"""Geodesics that are followed from a point in a direction, over seams and through poles."""
