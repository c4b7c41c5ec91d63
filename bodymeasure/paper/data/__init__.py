"""The paper's random patches, what it published, and the true lengths."""
