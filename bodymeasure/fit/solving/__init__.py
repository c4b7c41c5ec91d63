"""The model of bodies fitted to a scan: a coarse start, shape and pose, then its own surface."""
