"""Head, hands and feet, which the layout of patches leaves out, measured on the whole quad mesh."""

from bodymeasure.extremities.measure import extremity_lengths

__all__ = ["extremity_lengths"]
