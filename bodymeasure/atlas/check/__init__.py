"""The check of an atlas: gaps, folds, collapsed edges, kinks; and the welding of gaps."""
