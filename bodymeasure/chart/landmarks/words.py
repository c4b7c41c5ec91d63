"""Rules for landmarks in words."""

from bodymeasure.chart.landmarks.rules import (
    AtHeight,
    Between,
    Boundary,
    Fork,
    GirthLevel,
    Hollow,
    LandmarkRule,
    Level,
    Median,
    Prominent,
)

_TOWARDS = {
    "front": "to the front",
    "back": "to the back",
    "left": "to the left",
    "right": "to the right",
    "up": "up",
    "down": "down",
    "{side}": "to the {side}",
}


def rule_words(rule: LandmarkRule) -> str:
    """How a rule finds its landmark, in words without a full stop.

    Examples
    --------
    >>> rule_words(Level(name="side waist point left", of="front waist point", facing="left"))
    'outermost to the left at the height of front waist point'
    """
    match rule:
        case Between():
            return f"{rule.fraction:.4g} of the way from {rule.start} to {rule.end}"
        case AtHeight():
            return f"on the way from {rule.start} to {rule.end} at the height of {rule.of}"
        case Level():
            return f"outermost {_TOWARDS[rule.facing]} at the height of {rule.of}"
        case Median():
            return (
                f"{rule.facing} of the median plane through {rule.through} at the height of "
                f"{rule.of}"
            )
        case Prominent():
            above = "" if rule.above is None else f" above {rule.above}"
            below = "" if rule.below is None else f" below {rule.below}"
            both = " and" if above and below else ""
            regions = _listed(rule.regions)
            return f"farthest {_TOWARDS[rule.direction]} of {regions}{above}{both}{below}"
        case Fork():
            return f"where {rule.regions[0]} and {rule.regions[1]} part"
        case Hollow():
            return f"deepest below the chord from {rule.start} to {rule.end}"
        case GirthLevel():
            return (
                f"outermost {_TOWARDS[rule.facing]} at the {rule.extreme} girth from {rule.start} "
                f"to {rule.end}"
            )
        case Boundary():
            return f"farthest {_TOWARDS[rule.direction]} of the boundary of {_listed(rule.regions)}"


def _listed(names: tuple[str, ...]) -> str:
    return ", ".join(names)
