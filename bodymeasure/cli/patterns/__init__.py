"""Commands that make flat pieces from bodies."""
