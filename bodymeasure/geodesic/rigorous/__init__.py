"""Enclosures of lengths in exact and in ball arithmetic, without rounding errors left aside."""
