"""The tables of a reproduction."""
