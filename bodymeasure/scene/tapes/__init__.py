"""Pictures of a chart's tapes."""
