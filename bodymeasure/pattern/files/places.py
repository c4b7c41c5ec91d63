"""Where on which seam the edges of a pattern lie, and where they are notched."""

from typing import NamedTuple

from bodymeasure.pattern.definitions.panels import Panel
from bodymeasure.pattern.pieces.pattern import Pattern

# Parts of a seam nearer than this are one place.
SAME = 1e-6
# Where a seam is notched of which nothing else is said, and one into which cloth is eased evenly:
# it is spread between the notches.
MIDDLE, EASED = (0.5,), (0.25, 0.75)


class Place(NamedTuple):
    """Where on a seam an edge lies, or a part of one.

    Parameters
    ----------
    seam : tuple of str
        What is sewn together has this in common; empty if it is sewn to nothing.
    side : int
        Which of both sides of the seam it is, 0 or 1.
    start, end : float
        The part of the seam that it takes, from 0 to 1.
    runs_back : bool
        Whether the seam's direction is the other one.
    """

    seam: tuple[str, ...]
    side: int = 0
    start: float = 0.0
    end: float = 1.0
    runs_back: bool = False

    def on_seam(self, part: float) -> float:
        """Return the part of the seam at a part of the edge."""
        along = 1.0 - part if self.runs_back else part
        return self.start + (self.end - self.start) * along

    def on_edge(self, part: float) -> float:
        """Return the part of the edge at a part of the seam; outside of [0, 1] beyond it."""
        along = (part - self.start) / (self.end - self.start)
        return 1.0 - along if self.runs_back else along


def seam_places(pattern: Pattern) -> dict[tuple[str, str], Place]:
    """Return where on which seam edges lie, by the names of pieces and edges.

    An edge that is part of two seams is there in the first of them only. What runs back is the
    edge as it is defined, from its first landmark to the last.
    """
    through = {
        (piece.name, edge.name): edge.through
        for piece in pattern.pieces
        for edge in piece.panel.edge
    }
    found: dict[tuple[str, str], Place] = {}
    for number, seam in enumerate(pattern.seams):
        names = [name for side in seam.sides for name in side]
        if len(set(names)) < len(names) or any(name in found for name in names):
            continue
        ends = [through[side[0]] for side in seam.sides if len(side) == 1]
        first = min(ends[0][0], ends[0][-1])
        for row, side in enumerate(seam.sides):
            here, done = first, 0.0
            for name in side:
                begin, stop = through[name][0], through[name][-1]
                # Sides that do not have their ends in common begin at the name that sorts first.
                back = stop == here or (begin != here and begin > stop)
                size = pattern[name[0]].edge(name[1]).length / seam.lengths[row]
                found[name] = Place(("seam", str(number)), row, done, done + size, back)
                here, done = begin if back else stop, done + size
    return found


def notched_parts(pattern: Pattern) -> dict[tuple[str, str], tuple[float, ...]]:
    """Return where edges are notched, as parts of their lengths from their defined starts.

    What is said of one edge of a seam holds for the edges on its other side; and where several
    edges in a row are sewn to one, that one is notched where they meet.
    """
    places = seam_places(pattern)
    edges = {(piece.name, edge.name): edge for piece in pattern.pieces for edge in piece.panel.edge}
    notched: dict[tuple[str, ...], list[float]] = {}
    for name, place in places.items():
        on_seam = notched.setdefault(place.seam, [])
        on_seam += [place.on_seam(part) for part in edges[name].notches or ()]
        on_seam += [end for end in (place.start, place.end) if SAME < end < 1.0 - SAME]
    eased = {places[name].seam for name in places if edges[name].ease}
    usual = {seam: EASED if seam in eased else MIDDLE for seam in notched}
    found = {}
    for name, edge in edges.items():
        if name not in places:
            found[name] = edge.notches or (MIDDLE if edge.seam and edge.notches is None else ())
            continue
        place = places[name]
        parts = {round(place.on_edge(each), 9) for each in notched[place.seam] or usual[place.seam]}
        found[name] = tuple(sorted(part for part in parts if SAME < part < 1.0 - SAME))
    return found


def is_backwards(panel: Panel, names: list[str]) -> bool:
    """Whether edges, by their names, come in the other order than in their panel."""
    defined = [edge.name for edge in panel.edge]
    if len(names) < 3 or names[0] not in defined:
        return False
    return names[1] == defined[defined.index(names[0]) - 1]
