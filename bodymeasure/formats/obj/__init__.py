"""Wavefront OBJ: free-form surfaces and meshes."""
