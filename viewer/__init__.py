"""The pyvista window of a measured body."""
