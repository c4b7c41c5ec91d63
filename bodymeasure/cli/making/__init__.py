"""Bodies made to measure."""
