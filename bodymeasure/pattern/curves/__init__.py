"""Curves on the skin, which bound pieces: geodesics and parts of plane sections."""
