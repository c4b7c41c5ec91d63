"""Names of landmarks: those of ISO 8559-1, and others that charts of measurements use."""

import re
from collections.abc import Collection

from bodymeasure.wording import nearest

SIDES = ("left", "right")
# Landmarks of ISO 8559-1 as secondary sources name them (the standard itself was not at hand, and
# its numbers differ between editions), and points of the levels that it defines, named by the same
# pattern. These lie on the median plane.
MEDIAN_NAMES = (
    "top of head",
    "forehead point",
    "front neck point",
    "back neck point",
    "front bust point",
    "front underbust point",
    "back bust point",
    "front waist point",
    "back waist point",
    "front natural waist point",
    "back natural waist point",
    "front top hip point",
    "back top hip point",
    "front hip point",
    "back hip point",
    "abdomen point",
    "navel point",
    "crotch point",
    "floor point",
)
# There is one of these on either side; the side follows the name.
PAIRED_NAMES = (
    "side neck point",
    "shoulder point",
    "front scye point",
    "back scye point",
    "armpit point",
    "armpit front fold point",
    "armpit back fold point",
    "bust point",
    "underbust point",
    "shoulder blade point",
    "lowest rib point",
    "highest hip bone point",
    "side waist point",
    "side natural waist point",
    "side top hip point",
    "side hip point",
    "buttock point",
    "gluteal fold point",
    "inner thigh point",
    "elbow point",
    "inner elbow point",
    "wrist point",
    "inner wrist point",
    "fingertip point",
    "patella point",
    "knee back point",
    "inner knee point",
    "tibial point",
    "calf point",
    "ankle point",
    "inner ankle point",
    "heel point",
)
KNOWN_NAMES = (*MEDIAN_NAMES, *(f"{name} {side}" for name in PAIRED_NAMES for side in SIDES))
# Names that anatomy and other programs have for the same points.
SYNONYMS = {
    "vertex": "top of head",
    "glabella": "forehead point",
    "suprasternale": "front neck point",
    "jugular notch": "front neck point",
    "cervicale": "back neck point",
    "c7": "back neck point",
    "nape": "back neck point",
    "omphalion": "navel point",
    "umbilicus": "navel point",
    "crotch": "crotch point",
    "acromion": "shoulder point",
    "axilla": "armpit point",
    "underarm point": "armpit point",
    "thelion": "bust point",
    "nipple": "bust point",
    "iliocristale": "highest hip bone point",
    "iliac crest": "highest hip bone point",
    "trochanterion": "side hip point",
    "olecranon": "elbow point",
    "ulnar styloid": "wrist point",
    "patella": "patella point",
    "knee cap": "patella point",
    "knee point": "patella point",
    "tibiale": "tibial point",
    "lateral malleolus": "ankle point",
    "outer ankle point": "ankle point",
    "medial malleolus": "inner ankle point",
}
# Two names that are at least so similar are taken for misspellings of each other.
NEAR = 0.8
_SIDE_WORDS = {"l": "left", "left": "left", "r": "right", "right": "right"}


def side_of(name: str) -> str:
    """Return the side with which a name ends, ``left`` or ``right``; else an empty string."""
    last = name.rpartition(" ")[2]
    return last if last in SIDES and last != name else ""


def other_side(name: str) -> str:
    """Return the name of a paired landmark's partner; a name without a side is its own partner."""
    side = side_of(name)
    return name if not side else name.removesuffix(side) + SIDES[1 - SIDES.index(side)]


def suggested_name(name: str, others: Collection[str] = ()) -> str | None:
    """Return the known name that a name resembles; None if it is known itself or resembles none.

    Parameters
    ----------
    name : str
    others : collection of str
        Names that are known in addition to `KNOWN_NAMES`, such as those of a set of definitions.

    Examples
    --------
    >>> suggested_name("Left_Bust-Point"), suggested_name("acromion r")
    ('bust point left', 'shoulder point right')
    """
    known = {*KNOWN_NAMES, *others}
    if name in known:
        return None
    words = re.split(r"[\s_.\-]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).strip().lower())
    sides = [_SIDE_WORDS[word] for word in words if word in _SIDE_WORDS]
    place = " ".join(word for word in words if word not in _SIDE_WORDS)
    place = SYNONYMS.get(place, place)
    plain = f"{place} {sides[0]}" if sides else place
    if plain in known:
        return plain
    return nearest(plain, sorted(known), similarity=NEAR)
