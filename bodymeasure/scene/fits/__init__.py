"""Pictures of bodies over the scans that they were fitted to."""
