"""Pictures of a body with the panels of a pattern on it."""
