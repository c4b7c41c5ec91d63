"""How the patches of an atlas meet at their edges and corners."""
