"""Files of patterns."""
