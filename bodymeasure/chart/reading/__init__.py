"""Files of definitions: how they are read, checked and described."""
