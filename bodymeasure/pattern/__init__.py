"""Flat pieces from bodies: the paper's map of single patches, and patterns of garments."""

from bodymeasure.pattern.definitions.panels import Dart, Edge, Extend, Panel, PatternDefinitions
from bodymeasure.pattern.definitions.read import SETS, load_pattern, set_text
from bodymeasure.pattern.files.dxf import pattern_dxf
from bodymeasure.pattern.files.garmentcode import pattern_garmentcode
from bodymeasure.pattern.files.pdf import PAPERS, pattern_pdf
from bodymeasure.pattern.files.report import pattern_json, pattern_record
from bodymeasure.pattern.files.strain import FULL_STRAIN, strain_colors, strain_pictures, strain_svg
from bodymeasure.pattern.files.svg import path_id, pattern_svg
from bodymeasure.pattern.flat.flatten import Flat
from bodymeasure.pattern.patches.colors import color_of
from bodymeasure.pattern.patches.sheet import patches_sheet, patches_table
from bodymeasure.pattern.patches.unfold import UnfoldedPatches, unfold_patches
from bodymeasure.pattern.pieces.graded import GradedPattern, grade_pattern
from bodymeasure.pattern.pieces.make import make_pattern
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece, PieceDart, PieceEdge
from bodymeasure.pattern.pieces.seams import Seam

__all__ = [
    "FULL_STRAIN",
    "PAPERS",
    "SETS",
    "Dart",
    "Edge",
    "Extend",
    "Flat",
    "GradedPattern",
    "Panel",
    "Pattern",
    "PatternDefinitions",
    "Piece",
    "PieceDart",
    "PieceEdge",
    "Seam",
    "UnfoldedPatches",
    "color_of",
    "grade_pattern",
    "load_pattern",
    "make_pattern",
    "patches_sheet",
    "patches_table",
    "path_id",
    "pattern_dxf",
    "pattern_garmentcode",
    "pattern_json",
    "pattern_pdf",
    "pattern_record",
    "pattern_svg",
    "set_text",
    "strain_colors",
    "strain_pictures",
    "strain_svg",
    "unfold_patches",
]
