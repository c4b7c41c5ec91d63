"""What lies beyond an edge or a corner of a patch."""
