"""The analysis that the paper left to others, in figures: orders, forms, quadrature, conjugacy."""
