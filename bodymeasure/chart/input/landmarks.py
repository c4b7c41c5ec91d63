"""How far the landmarks of a body that was fitted to a scan may be from their places."""

from statistics import median

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Trust
from bodymeasure.chart.landmarks.derive import Derived


def landmark_trust(atlas: Atlas, derived: Derived) -> Trust:
    """Return how far landmarks may be trusted on an atlas that was fitted to a scan.

    A landmark that a rule of the definitions has given is as uncertain as the most uncertain one
    that its rule names: halfway between two it is less so, and at the height of another as much.
    One whose rule names none, and goes by the shape alone, is as uncertain as half of the others.

    Parameters
    ----------
    atlas : Atlas
    derived : Derived
        The atlas's own landmarks, and those of rules.
    """
    if atlas.scan is None:
        return Trust({}, {})
    bare = set(atlas.scan.uncovered.tolist())
    uncertainty = {
        name: found.uncertainty / atlas.unit.meters for name, found in atlas.scan.landmarks.items()
    }
    typical = median(uncertainty.values()) if uncertainty else 0.0
    unseen = {name: name for name, point in derived.landmarks.items() if point.patch in bare}
    # A rule comes after those whose landmarks it needs.
    for name, rule in derived.rules.items():
        named = rule.landmarks
        uncertainty[name] = max((uncertainty.get(each, 0.0) for each in named), default=typical)
        guessed = [unseen[each] for each in named if each in unseen]
        if guessed:
            unseen.setdefault(name, guessed[0])
    return Trust(uncertainty, unseen)
