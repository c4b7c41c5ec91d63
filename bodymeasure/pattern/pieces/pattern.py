"""A pattern: the flat pieces of a set of panels on a body, and the seams that join them."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.pattern.definitions.panels import PatternDefinitions
from bodymeasure.pattern.definitions.read import known_seams
from bodymeasure.pattern.definitions.seams import lonely_seams
from bodymeasure.pattern.pieces.piece import Piece
from bodymeasure.pattern.pieces.seams import Seam, seams_of
from bodymeasure.wording import counted


@dataclass(frozen=True, eq=False)
class Pattern:
    """The flat pieces of a set of panels on a body.

    Parameters
    ----------
    atlas : Atlas
    definitions : PatternDefinitions
    landmarks : mapping of str to AtlasPoint
        The landmarks that were known.
    pieces : tuple of Piece
    ease : mapping of str to float
        By how much girths are wider than those of the body, in meters, by the names of levels.
    bridge : bool
        Whether the cloth bridges hollows inside of the pieces.
    seconds : mapping of str to float
        The processor time for each piece.
    """

    atlas: Atlas
    definitions: PatternDefinitions
    landmarks: Mapping[str, AtlasPoint]
    pieces: tuple[Piece, ...]
    ease: Mapping[str, float] = field(default_factory=dict)
    bridge: bool = False
    seconds: Mapping[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Piece:
        """The piece of that name.

        Raises
        ------
        KeyError
            If there is none.
        """
        for piece in self.pieces:
            if piece.name == name:
                return piece
        raise KeyError(name)

    @property
    def seams(self) -> tuple[Seam, ...]:
        """The seams between pieces, in the order of the pieces."""
        return tuple(seams_of(self.pieces))

    @property
    def is_sound(self) -> bool:
        """Whether all pieces are sound and all seams match.

        A dart that was left out, or cloth that has to give much, is a warning, but no fault.
        """
        millimeters = 1000.0 * self.atlas.unit.meters
        return all(piece.is_sound for piece in self.pieces) and all(
            abs(millimeters * seam.excess) <= UNEQUAL for seam in self.seams
        )

    @property
    def warnings(self) -> tuple[str, ...]:
        """What there is to look at, with the names of the pieces and seams."""
        result = [f"{piece.name}: {words}" for piece in self.pieces for words in piece.warnings]
        meters = self.atlas.unit.meters
        result.extend(lonely_seams([piece.panel for piece in self.pieces], known_seams()))
        result.extend(
            self._unequal(seam)
            for seam in self.seams
            if abs(1000.0 * meters * seam.excess) > UNEQUAL
        )
        return tuple(result)

    def _unequal(self, seam: Seam) -> str:
        difference, ease = (
            1000.0 * self.atlas.unit.meters * length for length in (seam.difference, seam.ease)
        )
        wanted = f", and not {_longer(ease)}, as their ease asks" if ease else ""
        return (
            f"seam {seam.name!r}: {seam.edges[1]!r} of {seam.pieces[1]!r} is {_longer(difference)} "
            f"than {seam.edges[0]!r} of {seam.pieces[0]!r}{wanted}; let both lead through "
            "the same landmarks, or give the longer one that ease"
        )

    def __repr__(self) -> str:
        return (
            f"<Pattern {self.definitions.name!r} of {self.atlas.name!r}: "
            f"{counted(len(self.pieces), 'piece')}, {counted(len(self.seams), 'seam')}>"
        )


# In millimeters: seams that differ by less are equal, but for rounding.
UNEQUAL = 1e-6


def _longer(difference: float) -> str:
    size = abs(difference)
    than = "shorter" if difference < 0.0 else "longer"
    return f"{size:{'.1g' if size < 1.0 else '.1f'}} mm {than}"
