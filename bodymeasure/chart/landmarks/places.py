"""Where the landmarks lie on a body, in words for whoever has to pick them."""

from bodymeasure.chart.landmarks.names import side_of

_MEDIAN = {
    "top of head": "the highest point of the head",
    "forehead point": "the most forward point of the forehead, between the brows",
    "front neck point": "the upper edge of the breastbone, in the hollow between the collarbones",
    "back neck point": "the tip of the most prominent vertebra at the base of the neck (C7)",
    "front bust point": "the middle of the front at the height of the bust points",
    "front underbust point": "the middle of the front just below the breasts",
    "back bust point": "the middle of the back at the height of the bust points",
    "front waist point": "the middle of the front at the waist",
    "back waist point": "the middle of the back at the waist",
    "front natural waist point": "the middle of the front where the trunk is narrowest",
    "back natural waist point": "the middle of the back where the trunk is narrowest",
    "front top hip point": "the middle of the front at the height of the hip bones",
    "back top hip point": "the middle of the back at the height of the hip bones",
    "front hip point": "the middle of the front at the level of the fullest part of the buttocks",
    "back hip point": "the middle of the back at the level of the fullest part of the buttocks",
    "abdomen point": "the most forward point of the belly",
    "navel point": "the middle of the navel",
    "crotch point": "the lowest point of the trunk, between the legs",
}
_PAIRED = {
    "side neck point": "where the side of the neck meets the shoulder, on the line of its base",
    "shoulder point": "the outer end of the shoulder, over the tip of the shoulder blade",
    "front scye point": "the front of the armhole, halfway down",
    "back scye point": "the back of the armhole, halfway down",
    "armpit point": "the highest point of the armpit",
    "armpit front fold point": "the upper end of the fold between arm and chest",
    "armpit back fold point": "the upper end of the fold between arm and back",
    "bust point": "the most forward point of the breast",
    "underbust point": "where the breast meets the chest, below the bust point",
    "shoulder blade point": "the most backward point of the shoulder blade",
    "lowest rib point": "the lower edge of the lowest rib, at the side",
    "highest hip bone point": "the upper edge of the hip bone, at the side",
    "side waist point": "the side of the trunk at the waist",
    "side natural waist point": "the side of the trunk where it is narrowest",
    "side top hip point": "the side at the height of the hip bones",
    "side hip point": "the side at the level of the fullest part of the buttocks",
    "buttock point": "the most backward point of the buttock",
    "gluteal fold point": "the middle of the fold below the buttock",
    "inner thigh point": "the inside of the thigh just below the crotch",
    "elbow point": "the tip of the elbow",
    "inner elbow point": "the middle of the crook of the arm",
    "wrist point": "the bone at the outer side of the wrist",
    "inner wrist point": "the middle of the inside of the wrist",
    "fingertip point": "the tip of the middle finger",
    "patella point": "the middle of the kneecap",
    "knee back point": "the middle of the hollow of the knee",
    "inner knee point": "the inside of the knee at the height of the kneecap",
    "tibial point": "the upper edge of the shin bone, just below the knee",
    "calf point": "the most backward point of the calf",
    "ankle point": "the outer ankle bone",
    "inner ankle point": "the inner ankle bone",
    "heel point": "the most backward point of the heel",
}


def place_in_words(name: str) -> str:
    """Return where a landmark lies; empty if its name is none of those that are known.

    Examples
    --------
    >>> place_in_words("patella point left")
    "the middle of the kneecap, on the wearer's left"
    """
    side = side_of(name)
    if not side:
        return _MEDIAN.get(name, "")
    where = _PAIRED.get(name.removesuffix(f" {side}"), "")
    return f"{where}, on the wearer's {side}" if where else ""
