"""`bodymeasure landmarks` and its commands."""
