"""Fitted bodies as meshes and coefficients for other programs."""

from bodymeasure.fit.export.write import write_fitted

__all__ = ["write_fitted"]
