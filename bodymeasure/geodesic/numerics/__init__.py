"""Linear algebra and Newton's methods for many small problems at once."""
