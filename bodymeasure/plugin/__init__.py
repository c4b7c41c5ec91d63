"""bodymeasure inside mesh tools: readers and the accessor ``measure`` of pyvista, GLB files.

pyvista finds them by entry points, and loads them when they are first needed.
"""
