"""Picked landmarks: how they are put on an atlas, and files of picked positions."""
