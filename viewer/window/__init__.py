"""The pyvista window of a measured body, and pictures of what it shows."""
