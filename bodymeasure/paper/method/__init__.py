"""The paper's two methods: two radial functions with all roots, and Ritz."""
