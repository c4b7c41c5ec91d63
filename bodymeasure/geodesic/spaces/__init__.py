"""Trial spaces: nodes, differentiation matrices and quadrature."""
