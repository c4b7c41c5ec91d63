"""Sample atlases; `bodymeasure.load_sample` reads them."""
