"""Bodies fitted to meshes: a triangle mesh of a person goes in, an atlas with landmarks comes out.

The model of bodies is in `bodymeasure.fit.model`, the data that it is made of in `data`.
"""
