"""Derivatives of landmarks that follow from others by rule."""

from bodymeasure._typing import Array
from bodymeasure.atlas import AtlasPoint
from bodymeasure.chart.body import Body
from bodymeasure.chart.landmarks.choice import direction_vector
from bodymeasure.chart.landmarks.rules.at_height import AtHeight
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.landmarks.rules.between import Between
from bodymeasure.chart.landmarks.rules.boundary import Boundary
from bodymeasure.chart.landmarks.rules.farthest import Farthest
from bodymeasure.chart.landmarks.rules.fork import Fork
from bodymeasure.chart.landmarks.rules.hollow import Hollow
from bodymeasure.chart.landmarks.rules.level import Level
from bodymeasure.chart.landmarks.rules.median import Median
from bodymeasure.chart.landmarks.rules.prominent import Prominent
from bodymeasure.make.gradient.extremes import pull_extreme, pull_on_lines, pull_outermost
from bodymeasure.make.gradient.on_ways import pull_at_height, pull_between, pull_hollow
from bodymeasure.make.gradient.pull import Pull


def pull_rule(pull: Pull, body: Body, rule: LandmarkRule, vector: Array) -> None:
    """Add the derivatives of a landmark that follows by a rule.

    Parameters
    ----------
    pull : Pull
    body : Body
    rule : LandmarkRule
    vector : ndarray, shape (3,)
        The derivative of the value with respect to the landmark's position.
    """
    point, axes = body.point(rule.name), body.atlas.axes
    match rule:
        case Between():
            pull_between(pull, body, rule, vector)
        case AtHeight():
            pull_at_height(pull, body, rule, vector)
        case Hollow():
            pull_hollow(pull, body, rule, vector)
        case Level():
            direction = direction_vector(body.atlas, rule.facing)
            pull_outermost(pull, point, direction, rule.of, vector)
        case Median():
            lines = ((axes.up_vector, rule.of), (axes.left_vector, rule.through))
            pull_on_lines(pull, point, lines, vector)
        case Prominent() | Boundary():
            pull_extreme(pull, point, direction_vector(body.atlas, rule.direction), vector)
        case Fork():
            pull_extreme(pull, point, axes.up_vector, vector)
        case Farthest():
            pull.at(_chosen(body, rule, point), vector)
        case _:
            # The place stays on its patch, to which rules of other kinds come near.
            pull.point(point, vector)


def has_derivative(rule: LandmarkRule) -> bool:
    """Return whether a rule's landmark has its own derivative here."""
    known = (Between, AtHeight, Hollow, Level, Median, Prominent, Boundary, Fork, Farthest)
    return isinstance(rule, known)


def _chosen(body: Body, rule: Farthest, point: AtlasPoint) -> str:
    return next(name for name in rule.of if body.point(name) == point)
