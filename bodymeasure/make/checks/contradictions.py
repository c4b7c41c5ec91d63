"""Measurements of which one cannot be larger than the other, whatever the body."""

from collections.abc import Mapping
from typing import NamedTuple

# In meters: two tapes in the hand may differ by that much.
SLACK = 0.01


class _Order(NamedTuple):
    smaller: str
    larger: str
    because: str


_PART = "it is a part of it"
_FLOOR = "both are taken from the floor, and it ends below"
# With {side}, both measurements are of one side.
_ORDERS = (
    _Order("underbust_girth", "bust_girth", "the tape under the bust goes round less"),
    _Order("wrist_girth_{side}", "forearm_girth_{side}", "the forearm narrows to the wrist"),
    _Order("wrist_girth_{side}", "upper_arm_girth_{side}", "the arm narrows to the wrist"),
    _Order("wrist_girth_{side}", "elbow_girth_{side}", "the arm narrows to the wrist"),
    _Order("ankle_girth_{side}", "calf_girth_{side}", "the calf is the fullest part"),
    _Order("ankle_girth_{side}", "knee_girth_{side}", "the leg narrows to the ankle"),
    _Order("knee_girth_{side}", "thigh_girth_{side}", "the leg narrows to the knee"),
    _Order("mid_thigh_girth_{side}", "thigh_girth_{side}", "the thigh narrows to the knee"),
    _Order("thigh_girth_{side}", "hip_girth", "the hips hold both thighs"),
    _Order("neck_girth", "bust_girth", "the neck is thinner than the trunk"),
    _Order("bust_front_arc", "bust_girth", _PART),
    _Order("bust_back_arc", "bust_girth", _PART),
    _Order("high_bust_front_arc", "high_bust_girth", _PART),
    _Order("waist_front_arc", "waist_girth", _PART),
    _Order("waist_back_arc", "waist_girth", _PART),
    _Order("hip_front_arc", "hip_girth", _PART),
    _Order("hip_back_arc", "hip_girth", _PART),
    _Order("crotch_length_front", "crotch_length", _PART),
    _Order("crotch_length_back", "crotch_length", _PART),
    _Order("upper_arm_length_{side}", "arm_length_{side}", _PART),
    _Order("forearm_length_{side}", "arm_length_{side}", _PART),
    _Order("arm_length_{side}", "back_neck_to_wrist_{side}", _PART),
    _Order("shoulder_length_{side}", "shoulder_width", "a shoulder is less than both"),
    _Order("shoulder_length_{side}", "shoulder_width_over_neck", "a shoulder is less than both"),
    _Order("side_neck_to_bust_{side}", "side_neck_to_waist_over_bust_{side}", _PART),
    _Order("waist_to_top_hip_{side}", "waist_to_hip_{side}", _PART),
    _Order("knee_height_{side}", "inner_leg_length", _FLOOR),
    _Order("inner_leg_length", "hip_height_{side}", _FLOOR),
    _Order("inner_leg_length", "outer_leg_length_{side}", "the crotch is below the waist"),
    _Order("inner_leg_length", "waist_height_{side}", _FLOOR),
    _Order("hip_height_{side}", "waist_height_{side}", _FLOOR),
    _Order("knee_height_{side}", "waist_height_{side}", _FLOOR),
    _Order("waist_height_{side}", "back_neck_height", _FLOOR),
    _Order("waist_height_{side}", "stature", _FLOOR),
    _Order("back_neck_height", "stature", _FLOOR),
    _Order("shoulder_height_{side}", "stature", _FLOOR),
    _Order("inner_leg_length", "stature", _FLOOR),
    _Order("outer_leg_length_{side}", "stature", "the waist is below the crown"),
    _Order("waist_breadth", "waist_girth", "a girth goes round the breadth"),
    _Order("hip_breadth", "hip_girth", "a girth goes round the breadth"),
)


class Contradiction(NamedTuple):
    """Two values that no body has.

    Parameters
    ----------
    smaller, larger : str
        The key of the measurement that should be the smaller one, and of the other.
    because : str
    """

    smaller: str
    larger: str
    because: str


def contradictions(values: Mapping[str, float]) -> list[Contradiction]:
    """Return the pairs of values, in meters, that contradict each other."""
    found = []
    for order in _ORDERS:
        for side in ("left", "right") if "{side}" in "".join(order[:2]) else ("",):
            smaller, larger = (key.replace("{side}", side) for key in order[:2])
            if smaller in values and larger in values and values[smaller] > values[larger] + SLACK:
                found.append(Contradiction(smaller, larger, order.because))
    return found
