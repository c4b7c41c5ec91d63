"""Rules by which landmarks follow from others, so that a new body needs few picks."""

from collections.abc import Mapping
from typing import ClassVar, Literal

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Entry

Facing = Literal["front", "back", "left", "right", "{side}"]
"""A horizontal direction, as the wearer sees it."""
Direction = Literal[Facing, "up", "down"]
"""Any direction, as the wearer sees it."""
Landmarks = Mapping[str, AtlasPoint]
"""Points by the names of landmarks."""


class LandmarkRule(Entry, frozen=True, kw_only=True, tag_field="rule"):
    """A rule by which a landmark follows from others; each rule adds members of its own.

    Parameters
    ----------
    name : str
        Name of the landmark that the rule gives, as in ISO 8559-1. ``{side}`` in it and in the
        names to which it refers stands for left and right in turn.
    words : str
        A description of the landmark, for the user.
    """

    label: ClassVar[str] = "name"

    name: str
    words: str = ""

    @property
    def description(self) -> str:
        """A description of how the rule finds its landmark, without a full stop."""
        raise NotImplementedError

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        """Return the landmark on an atlas; of mirror images, the one on the wearer's left.

        Parameters
        ----------
        atlas : Atlas
        landmarks : mapping of str to AtlasPoint
            The landmarks to which the rule refers are among them.

        Raises
        ------
        InputError
            If the atlas has no such point.
        ConvergenceError
            If a solver does not converge.
        """
        raise NotImplementedError


def towards(direction: Direction) -> str:
    """Return a direction in words."""
    return direction if direction in ("up", "down") else f"to the {direction}"
