"""The findings of the check of an atlas."""

from dataclasses import dataclass
from enum import StrEnum


class Severity(StrEnum):
    """The weight of a finding: it spoils measurements, or only deserves a look."""

    ERROR = "error"
    WARNING = "warning"


class FindingKind(StrEnum):
    """The kinds of findings; the values are words for tables."""

    DIRECTIONS = "wrong directions"
    TURNED = "turned body"
    SIDES = "exchanged sides"
    ORDER = "wrong order"
    SIZE = "unlikely size"
    COLLAPSED_PATCH = "collapsed patch"
    FOLDED_PATCH = "folded patch"
    SEAM_GAP = "seam gap"
    NON_MANIFOLD_SEAM = "non-manifold seam"
    COLLAPSED_EDGE = "collapsed edge"
    SINGULAR_CORNER = "degenerate corner"
    SINGULAR_POINT = "degenerate point"
    UNJOINED_SEAM = "seam not joined"
    T_JUNCTION = "T-junction"
    ORIENTATION = "turned patch"
    KINKED_SEAM = "kinked seam"
    SEPARATE_PARTS = "separate parts"


@dataclass(frozen=True)
class Finding:
    """One thing that a check of an atlas found.

    Parameters
    ----------
    severity : Severity
    kind : FindingKind
    patches : tuple of int
        Numbers of the patches concerned; none if the finding is on the landmarks.
    message : str
        The patches and edges by name, the numbers with their unit, what was expected, and the
        remedy.
    """

    severity: Severity
    kind: FindingKind
    patches: tuple[int, ...]
    message: str
