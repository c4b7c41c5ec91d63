"""Numbers, names and leaders over pictures of tapes."""

from collections.abc import Sequence

import numpy as np

from bodymeasure.scene.figures.canvas import Lines, Text
from bodymeasure.scene.tapes.label_layout import Columns, Layout

LEADER = (0.30, 0.31, 0.34)
WHITE = (1.0, 1.0, 1.0)
# Widths and sizes in heights of a label.
LEADER_WIDTH = 0.055
HALO_WIDTH = 0.12
DOT = 0.28
# Distance between a leader's start and its label, in sizes of the text.
TEXT_GAP = 0.18


def leaders(layout: Layout, columns: Columns, height: float) -> list[Lines]:
    """Draw lines from labels to what they label, with white rims and with dots at their ends."""
    start = np.stack([np.where(layout.on_right, columns.right, columns.left), layout.y], axis=-1)
    lines = list(np.stack([start, layout.anchor], axis=1))
    # A line of no length would not be drawn.
    dots = list(layout.anchor[:, None] + np.array([(-0.5, 0.0), (0.5, 0.0)]))
    return [
        (lines, np.tile(WHITE, (len(lines), 1)), HALO_WIDTH * height),
        (dots, np.tile(WHITE, (len(lines), 1)), (DOT + 0.12) * height),
        (lines, np.tile(LEADER, (len(lines), 1)), LEADER_WIDTH * height),
        (dots, np.tile(LEADER, (len(lines), 1)), DOT * height),
    ]


def column_texts(texts: Sequence[str], layout: Layout, columns: Columns, size: float) -> list[Text]:
    """Place texts in their columns; those of the left column end at its inner edge."""
    gap = TEXT_GAP * size
    return [
        Text(columns.right + gap, y, text, size, horizontal="left")
        if on_right
        else Text(columns.left - gap, y, text, size, horizontal="right")
        for text, on_right, y in zip(texts, layout.on_right, layout.y, strict=True)
    ]
