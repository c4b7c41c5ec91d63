"""Pictures of a survey's diagonals."""
