"""Picked landmarks: putting them on an atlas, and files of picked positions."""
