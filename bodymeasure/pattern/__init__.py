"""Flat pieces from bodies: the paper's map of single patches."""

from bodymeasure.pattern.patches.sheet import patches_sheet, patches_table
from bodymeasure.pattern.patches.unfold import UnfoldedPatches, unfold_patches

__all__ = [
    "UnfoldedPatches",
    "patches_sheet",
    "patches_table",
    "unfold_patches",
]
