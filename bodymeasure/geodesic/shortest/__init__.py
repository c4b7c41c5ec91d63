"""The search for the shortest path within one patch."""
