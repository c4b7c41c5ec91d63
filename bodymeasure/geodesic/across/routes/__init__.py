"""Routes: the patches and seams that a path crosses, read off a path over a triangle mesh."""
