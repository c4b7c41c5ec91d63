"""Names of landmarks that definitions and atlases may use."""

from __future__ import annotations

# On the median plane, and one on either side.
MEDIAN_NAMES = (
    "top of head",
    "front neck point",
    "back neck point",
    "front waist point",
    "back waist point",
    "crotch point",
)
PAIRED_NAMES = (
    "side neck point",
    "shoulder point",
    "bust point",
    "side waist point",
    "elbow point",
    "wrist point",
    "patella point",
)
KNOWN_NAMES = (
    *MEDIAN_NAMES,
    *(f"{name} {side}" for name in PAIRED_NAMES for side in ("left", "right")),
)
