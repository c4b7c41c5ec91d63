"""The problems that the benchmark solves, and their true lengths."""
