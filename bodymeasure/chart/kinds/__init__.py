"""The kinds of measurements: how each is written, and how it is taken."""
