"""Rules by which landmarks follow from others, so that a new body needs few picks."""

from typing import Literal

import msgspec

Facing = Literal["front", "back", "left", "right", "{side}"]
"""A horizontal direction, as the wearer sees it."""


class Rule(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="rule"):
    """What all rules have.

    Parameters
    ----------
    name : str
        Of the landmark that the rule gives, as in ISO 8559-1. ``{side}`` in it, and in the names
        it refers to, stands for left and right in turn.
    words : str
        What the landmark is, for the user.
    """

    name: str
    words: str = ""


class Between(Rule, frozen=True, kw_only=True, tag="between"):
    """A point of the geodesic between two landmarks, at a fraction of its length."""

    start: str
    end: str
    fraction: float = 0.5


class AtHeight(Rule, frozen=True, kw_only=True, tag="at height"):
    """Where the geodesic between two landmarks first passes the height of a third."""

    start: str
    end: str
    of: str


class Level(Rule, frozen=True, kw_only=True, tag="level"):
    """The outermost point, in a direction, of the horizontal section at a landmark's height.

    Of the sections's loops, the one that passes closest to the landmark `of`.
    """

    of: str
    facing: Facing


class Median(Rule, frozen=True, kw_only=True, tag="median"):
    """The front or back point of the median plane at a landmark's height.

    The median plane runs through the landmark `through`, from front to back.
    """

    of: str
    through: str
    facing: Literal["front", "back"]


class Prominent(Rule, frozen=True, kw_only=True, tag="prominent"):
    """The point of some regions that lies farthest in a direction.

    Regions are given by the beginnings of their names; `above` and `below` are landmarks between
    whose heights the point has to lie.
    """

    direction: Facing | Literal["up", "down"]
    regions: tuple[str, ...]
    above: str | None = None
    below: str | None = None


class Fork(Rule, frozen=True, kw_only=True, tag="fork"):
    """Where two parts of the body part, going down: armpit and crotch.

    The saddle of the height at which the horizontal section's loop divides into one for each of
    the two regions (beginnings of names).
    """

    regions: tuple[str, str]


class Hollow(Rule, frozen=True, kw_only=True, tag="hollow"):
    """The point of the geodesic between two landmarks that lies deepest below its chord."""

    start: str
    end: str


class GirthLevel(Rule, frozen=True, kw_only=True, tag="girth level"):
    """A point at the height where the girth between two landmarks is the largest or smallest."""

    start: str
    end: str
    extreme: Literal["largest", "smallest"]
    facing: Facing


class Boundary(Rule, frozen=True, kw_only=True, tag="boundary"):
    """The point of the atlas's open boundary in some regions that lies farthest in a direction."""

    direction: Facing | Literal["up", "down"]
    regions: tuple[str, ...]


LandmarkRule = (
    Between | AtHeight | Level | Median | Prominent | Fork | Hollow | GirthLevel | Boundary
)
