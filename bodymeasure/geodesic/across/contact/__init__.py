"""Paths across patches that run along the border of the atlas for a part."""
