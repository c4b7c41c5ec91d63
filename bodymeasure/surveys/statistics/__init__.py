"""What a survey says of a population: percentiles, correlations, outliers, nearest bodies."""

from collections.abc import Sequence

from bodymeasure.surveys.statistics.correlations import correlations
from bodymeasure.surveys.statistics.nearest import Near, nearest_bodies
from bodymeasure.surveys.statistics.outliers import Outlier, outliers
from bodymeasure.surveys.statistics.percentiles import (
    PERCENTILES,
    Percentile,
    Summary,
    percentile_interval,
    summary,
)

# What sizes and correlations are about if nothing else is asked for, as far as it is there.
MAIN = (
    "stature",
    "neck_girth",
    "bust_girth",
    "underbust_girth",
    "waist_girth",
    "hip_girth",
    "thigh_girth_right",
    "upper_arm_girth_right",
    "shoulder_width",
    "back_neck_to_waist",
    "arm_length_right",
    "inner_leg_length",
)


def main_keys(keys: Sequence[str], *, count: int = len(MAIN)) -> tuple[str, ...]:
    """Return the measurements that matter most, of those that there are; or else the first."""
    found = tuple(key for key in MAIN if key in keys)
    return (found if len(found) > 1 else tuple(keys))[:count]


__all__ = [
    "MAIN",
    "PERCENTILES",
    "Near",
    "Outlier",
    "Percentile",
    "Summary",
    "correlations",
    "main_keys",
    "nearest_bodies",
    "outliers",
    "percentile_interval",
    "summary",
]
