"""Bodies of the space by their coefficients: atlas, prior, measurements and derivatives."""
