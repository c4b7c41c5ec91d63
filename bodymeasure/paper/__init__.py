"""A reproduction of Ng, Pong and Wong (2007): their method, their data and their tables."""

from bodymeasure.paper.method.normalization import Normalized, normalize

__all__ = ["Normalized", "normalize"]
