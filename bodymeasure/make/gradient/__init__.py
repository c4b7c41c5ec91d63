"""Derivatives of measurements with respect to the control points of an atlas.

A shortest path and a taut tape are as short as they can be, so that their own movement changes
nothing to first order: what counts is how the skin below them moves (the envelope theorem).
"""

from bodymeasure.make.gradient.measured import gradient_of, has_gradient

__all__ = ["gradient_of", "has_gradient"]
