"""Bodies of the space by their coefficients: atlas, prior, and the measurements with derivatives."""
