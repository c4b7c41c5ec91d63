"""Methods side by side: error against time, growth with the number of patches, where time goes."""
