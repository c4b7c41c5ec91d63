"""The page and the summary of a reproduction."""
