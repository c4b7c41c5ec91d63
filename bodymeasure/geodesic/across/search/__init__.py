"""The search for the shortest path or loop across patches."""
