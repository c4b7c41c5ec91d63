"""A body's landmarks completed by rules, whatever it lacks."""

from collections.abc import Sequence

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body
from bodymeasure.chart.landmarks.derive import derive_landmarks
from bodymeasure.chart.landmarks.names import KNOWN_NAMES
from bodymeasure.chart.landmarks.order import references
from bodymeasure.chart.landmarks.rules import LandmarkRule
from bodymeasure.chart.reading.sides import both_sides
from bodymeasure.wording import hint


def completed(atlas: Atlas, rules: Sequence[LandmarkRule]) -> Body:
    """A body with the landmarks that rules give on it, and reasons for those that they cannot.

    A rule that needs a landmark of which nobody has heard is no error here, as it is to
    `derive_landmarks`: users pick landmarks of their own, and not on every body.

    Raises
    ------
    InputError
        If rules need one another in a circle.
    """
    usable = {rule.name: rule for rule in both_sides(rules) if rule.name not in atlas.landmarks}
    missing: dict[str, str] = {}
    while lacking := _first_lacking(atlas, usable, missing):
        name, reason = lacking
        missing[name] = reason
        del usable[name]
    derived = derive_landmarks(atlas, usable.values())
    return Body(atlas, derived.landmarks, {**derived.missing, **missing})


def _first_lacking(
    atlas: Atlas, usable: dict[str, LandmarkRule], missing: dict[str, str]
) -> tuple[str, str] | None:
    """A rule that needs a landmark which there cannot be, and why; None if there is none."""
    known = {*atlas.landmarks, *usable, *KNOWN_NAMES} - set(missing)
    for rule in usable.values():
        for needed in references(rule):
            if needed in missing:
                return rule.name, f"it needs {needed!r}, which is missing: {missing[needed]}"
            if needed not in known:
                near = hint(needed, sorted(known))
                remedy = near if near.startswith("did you mean") else "pick it, or give it a rule"
                return rule.name, f"it needs {needed!r}, which no landmark is called; {remedy}"
    return None
