"""The search for the shortest path across patches."""
