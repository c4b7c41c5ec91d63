"""Single patches unfolded into the plane, as the paper does it."""
