"""Sections by planes through poles: sides of patches that are collapsed to a point."""
