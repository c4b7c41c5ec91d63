"""Which patches and seams a path crosses, and where it starts from."""
