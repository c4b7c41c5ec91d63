"""The viewer's page without its server: as one file, and in a notebook."""
