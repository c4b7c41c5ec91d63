"""The edges and corners at which the patches of an atlas meet."""
