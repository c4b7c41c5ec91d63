"""The two renderers: pyvista, and software for machines without OpenGL."""
