"""Tapes that lie on a body, to be drawn."""

from dataclasses import dataclass
from enum import StrEnum

from bodymeasure._typing import Array


class TapeKind(StrEnum):
    """The way in which a tape lies on a body."""

    CONTACT = "contact"
    TAUT = "taut"
    STRAIGHT = "straight"


@dataclass(frozen=True, eq=False)
class Tape:
    """A tape, to be drawn.

    Parameters
    ----------
    kind : TapeKind
    points : ndarray, shape (k, 3)
        Points along the tape, in the atlas's unit; a closed tape ends at its first point.
    normals : ndarray, shape (k, 3)
        Unit vectors away from the body, along which the drawn tape is lifted; 0 where the tape
        does not touch the body.
    """

    kind: TapeKind
    points: Array
    normals: Array
