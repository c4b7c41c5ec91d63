"""Plain figures: canvas, style and color bars."""
