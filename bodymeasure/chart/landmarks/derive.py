"""Landmarks that follow from others by rule."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.landmarks.boundary import boundary_point
from bodymeasure.chart.landmarks.extremes import prominent_point
from bodymeasure.chart.landmarks.heights import at_height_point
from bodymeasure.chart.landmarks.order import expanded, in_order, references
from bodymeasure.chart.landmarks.paths import between_point, hollow_point
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
from bodymeasure.chart.landmarks.sections import girth_level_point, level_point, median_point
from bodymeasure.errors import BodymeasureError
from bodymeasure.measure.body.forks import fork_point


@dataclass(frozen=True, eq=False)
class Derived:
    """The landmarks of an atlas, its own and those that follow by rule.

    Parameters
    ----------
    landmarks : mapping of str to AtlasPoint
        The atlas's own first.
    missing : mapping of str to str
        Landmarks that rules could not give, and why.
    rules : mapping of str to LandmarkRule
        The rule of each landmark that is not the atlas's own, with left or right put in for
        ``{side}``; of those that are missing, too.
    """

    landmarks: Mapping[str, AtlasPoint]
    missing: Mapping[str, str]
    rules: Mapping[str, LandmarkRule] = field(default_factory=dict)


def derive_landmarks(atlas: Atlas, rules: Iterable[LandmarkRule]) -> Derived:
    """Find the landmarks that rules give on an atlas.

    Parameters
    ----------
    atlas : Atlas
        Its own landmarks win over rules of the same name.
    rules : iterable of LandmarkRule
        In any order; they may refer to one another. ``{side}`` stands for left and right in turn.

    Returns
    -------
    Derived

    Raises
    ------
    InputError
        If two rules give one landmark, rules need one another in a circle, or a name is unknown.
        A rule that this body cannot fulfill is no error: its landmark is missing, with the reason.

    Notes
    -----
    All points lie on the smooth surface and are exact but for rounding, those on geodesics but for
    the geodesics' own error. Of points that are equally far because they are mirror images, the one
    on the side of the landmark referred to is taken, else the wearer's left.
    """
    landmarks = dict(atlas.landmarks)
    missing: dict[str, str] = {}
    ordered = in_order(expanded(rules), landmarks)
    for rule in ordered:
        lacking = [name for name in references(rule) if name not in landmarks]
        if lacking:
            missing[rule.name] = _lacks(lacking[0], missing)
            continue
        try:
            landmarks[rule.name] = _point(atlas, rule, landmarks)
        except BodymeasureError as error:
            missing[rule.name] = str(error)
    return Derived(landmarks, missing, {rule.name: rule for rule in ordered})


def _lacks(name: str, missing: Mapping[str, str]) -> str:
    if name not in missing:
        return f"it needs {name!r}, which the atlas lacks and no rule gives; pick it"
    return f"it needs {name!r}, which is missing: {missing[name]}"


def _point(atlas: Atlas, rule: LandmarkRule, landmarks: dict[str, AtlasPoint]) -> AtlasPoint:
    positions = {name: atlas.position(landmarks[name]) for name in references(rule)}
    match rule:
        case Between():
            return between_point(atlas, rule, landmarks)
        case AtHeight():
            return at_height_point(atlas, rule, landmarks)
        case Hollow():
            return hollow_point(atlas, rule, landmarks)
        case Level():
            return level_point(atlas, rule, positions)
        case Median():
            return median_point(atlas, rule, positions)
        case GirthLevel():
            return girth_level_point(atlas, rule, positions)
        case Prominent():
            return prominent_point(atlas, rule, positions)
        case Boundary():
            return boundary_point(atlas, rule)
        case Fork():
            return fork_point(atlas, rule.regions)
