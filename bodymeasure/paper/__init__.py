"""Ng, Pong and Wong (2007), reproduced: their method, their data, their tables."""

from bodymeasure.paper.method.normalization import Normalized, normalize

__all__ = ["Normalized", "normalize"]
