"""Twenty sets of measurements that no body has, each with the reason and the one at fault.

Lengths are in centimeters. All start from the measurements of a woman of 168 cm, which are
possible.
"""

from typing import NamedTuple

WOMAN = {
    "stature": 168.0,
    "bust_girth": 88.0,
    "underbust_girth": 76.0,
    "waist_girth": 72.0,
    "hip_girth": 97.0,
    "thigh_girth_right": 56.0,
    "knee_girth_right": 36.5,
    "ankle_girth_right": 21.0,
    "upper_arm_girth_right": 27.5,
    "wrist_girth_right": 15.0,
    "neck_base_girth": 41.0,
    "shoulder_length_right": 12.7,
    "back_neck_to_waist": 41.5,
    "arm_length_right": 51.5,
    "inner_leg_length": 78.5,
    "knee_height_right": 50.0,
    "back_neck_height": 143.5,
    "waist_height_right": 102.5,
}


class Impossible(NamedTuple):
    """A set of measurements.

    Parameters
    ----------
    reason : str
        Why no body has it.
    changed : dict of str to float
        What differs from the woman's.
    culprits : tuple of str
        The measurements of which the refusal has to name one.
    says : str
        What it has to say besides.
    """

    reason: str
    changed: dict[str, float]
    culprits: tuple[str, ...]
    says: str = ""


IMPOSSIBLE = (
    Impossible("the waist lacks 30 cm", {"waist_girth": 42.0}, ("waist_girth",)),
    Impossible(
        "bust and hip are made for two people",
        {"bust_girth": 113.0, "hip_girth": 77.0},
        ("bust_girth", "hip_girth", "underbust_girth", "thigh_girth_right"),
    ),
    Impossible(
        "the tape under the bust is longer than that over it",
        {"underbust_girth": 92.0},
        ("underbust_girth",),
        "goes round less",
    ),
    Impossible(
        "the digits of the waist are swapped", {"waist_girth": 27.0}, ("waist_girth",), "swapped"
    ),
    Impossible(
        "the digits of the arm are swapped",
        {"arm_length_right": 15.5},
        ("arm_length_right",),
        "swapped",
    ),
    Impossible(
        "a decimal point is missing in the knee", {"knee_girth_right": 365.0}, ("knee_girth_right",)
    ),
    Impossible(
        "the wrist is in millimeters", {"wrist_girth_right": 150.0}, ("wrist_girth_right",), "15.0"
    ),
    Impossible("the hip is in inches", {"hip_girth": 38.2}, ("hip_girth",), "inch"),
    Impossible(
        "everything is in inches",
        {key: value / 2.54 for key, value in WOMAN.items()},
        (),
        "fit in inch",
    ),
    Impossible(
        "everything is in millimeters",
        {key: 10.0 * value for key, value in WOMAN.items()},
        (),
        "fit in mm",
    ),
    Impossible(
        "the leg ends above the waist",
        {"inner_leg_length": 108.0},
        ("inner_leg_length",),
        "both are taken from the floor",
    ),
    Impossible(
        "the knee is where the crotch is", {"knee_height_right": 76.0}, ("knee_height_right",)
    ),
    Impossible("the nape is above the crown", {"back_neck_height": 172.0}, ("back_neck_height",)),
    Impossible("a neck as thick as a thigh", {"neck_base_girth": 60.0}, ("neck_base_girth",)),
    Impossible("shoulders of a giant", {"shoulder_length_right": 22.0}, ("shoulder_length_right",)),
    Impossible(
        "the thighs are thicker than the hips allow",
        {"thigh_girth_right": 84.0},
        ("thigh_girth_right",),
    ),
    Impossible(
        "the back is as long as that of a man of two meters",
        {"back_neck_to_waist": 56.0},
        ("back_neck_to_waist",),
    ),
    Impossible(
        "the arm was measured from the nape", {"arm_length_right": 71.0}, ("arm_length_right",)
    ),
    Impossible("half of the hip was written", {"hip_girth": 48.5}, ("hip_girth",), "laid double"),
    Impossible("the stature of a child", {"stature": 118.0}, ("stature",)),
)
