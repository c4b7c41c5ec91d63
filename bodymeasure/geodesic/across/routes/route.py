"""A route over an atlas: patches in order, and the seams that are crossed between them."""

from dataclasses import dataclass

from bodymeasure.atlas.topology.neighbors import Crossing, Place, on_side

# What tells routes apart, wherever on their seams they cross.
RouteKey = tuple[tuple[int, ...], tuple[Crossing, ...]]


@dataclass(frozen=True)
class Route:
    """What a path crosses on its way, and about where.

    Parameters
    ----------
    start, end : Place
        On the first and on the last patch.
    crossings : tuple of Crossing
        In order; the first leaves the patch of the start.
    along : tuple of float
        Where each seam is crossed: the parameter in [0, 1] along the side that is left.
    """

    start: Place
    end: Place
    crossings: tuple[Crossing, ...]
    along: tuple[float, ...]

    @property
    def patches(self) -> tuple[int, ...]:
        """One patch more than crossings."""
        return (self.start.patch, *(crossing.to_patch for crossing in self.crossings))

    @property
    def key(self) -> RouteKey:
        """Equal for routes over the same patches and seams."""
        return self.patches, self.crossings

    def entry(self, piece: int) -> Place:
        """Where a piece starts, on its patch."""
        if piece == 0:
            return self.start
        crossing, along = self.crossings[piece - 1], self.along[piece - 1]
        along = 1.0 - along if crossing.flipped else along
        return Place(crossing.to_patch, *on_side(crossing.to_side, along))

    def exit(self, piece: int) -> Place:
        """Where a piece ends, on its patch."""
        if piece == len(self.crossings):
            return self.end
        side = self.crossings[piece].from_side
        return Place(self.patches[piece], *on_side(side, self.along[piece]))
