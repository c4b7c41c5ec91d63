"""The methods that users choose from: collocation, Ritz, shooting, relaxation."""
