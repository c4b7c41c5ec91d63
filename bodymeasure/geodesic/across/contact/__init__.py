"""Paths across patches that edges of the atlas, or seams, hold for a part."""
