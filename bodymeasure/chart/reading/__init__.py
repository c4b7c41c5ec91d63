"""Reading files of definitions, and checking them."""
