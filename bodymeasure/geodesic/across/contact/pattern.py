"""The parts of a path over several patches that are free, and those that an edge holds.

They are read off a polygon at rest, patch by patch as in `read_legs`; free parts go on over the
seams that they cross.
"""

from dataclasses import dataclass

from bodymeasure._typing import Array
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.problem import Slides
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.contact.legs import Contact, read_legs


@dataclass(frozen=True)
class FreePart:
    """A part of a path that nothing holds.

    Parameters
    ----------
    first, last : tuple of int
        The piece of the polygon, and the node in it, where the part starts and ends.
    slides : pair of int or None
        The side of its patch on which the part starts, and ends, if it may slide along that side.
    """

    first: tuple[int, int]
    last: tuple[int, int]
    slides: Slides


@dataclass(frozen=True)
class HeldPart:
    """A part of a path along an edge of one patch.

    Parameters
    ----------
    piece : int
        The piece of the polygon.
    contact : Contact
        The edge.
    first, last : int
        The nodes where it starts and ends.
    """

    piece: int
    contact: Contact
    first: int
    last: int


Part = FreePart | HeldPart


def read_pattern(polygon: RefinedPath) -> list[Part]:
    """Return the free and the held parts of a polygon, in order."""
    parts: list[Part] = []
    route, lengths = polygon.route, polygon.lengths
    pieces = [number for number in range(len(lengths)) if lengths[number] > 0.0]
    for before, piece in zip([-1, *pieces[:-1]], pieces, strict=True):
        here = _of_piece(polygon, piece)
        # Only a path that crosses one seam, and not in its ends, may move along it.
        crosses = piece == before + 1 > 0 and 0.0 < route.along[before] < 1.0
        if parts and crosses:
            parts[-1:], here = _joined(route, before, parts[-1], here)
        parts += here
    return parts


def _of_piece(polygon: RefinedPath, piece: int) -> list[Part]:
    result: list[Part] = []
    for leg in read_legs(polygon.values[piece].T):
        if leg.contact is not None:
            result.append(HeldPart(piece, leg.contact, leg.first, leg.last))
        else:
            start, end = (None if each is None else side_of(each) for each in leg.ends)
            result.append(FreePart((piece, leg.first), (piece, leg.last), (start, end)))
    return result


def _joined(
    route: Route, before: int, last: Part, here: list[Part]
) -> tuple[list[Part], list[Part]]:
    """The last part before a seam, and the parts after it; what crosses it freely is one part."""
    crossing, first = route.crossings[before], here[0]
    if isinstance(last, FreePart) and isinstance(first, FreePart):
        return [FreePart(last.first, first.last, (last.slides[0], first.slides[1]))], here[1:]
    if isinstance(last, FreePart):
        return [FreePart(last.first, last.last, (last.slides[0], crossing.from_side))], here
    if isinstance(first, FreePart):
        slides = crossing.to_side, first.slides[1]
        return [last], [FreePart(first.first, first.last, slides), *here[1:]]
    return [last], here


def side_of(contact: Contact) -> int:
    """Return the number of an edge of a patch, in the order of `EDGES`."""
    return next(
        number
        for number, edge in enumerate(EDGES)
        if (edge.fixed_axis, edge.fixed_value) == (contact.axis, contact.value)
    )


def place_at(polygon: RefinedPath, piece: int, node: int) -> AtlasPoint:
    """Return the point of a node of a polygon."""
    u, v = polygon.values[piece, :, node].tolist()
    return AtlasPoint(polygon.route.patches[piece], u, v)


def free_route(polygon: RefinedPath, part: FreePart) -> Route:
    """Return the route of a free part."""
    (first, start), (last, end) = part.first, part.last
    route = polygon.route
    return Route(
        (place_at(polygon, first, start), place_at(polygon, last, end)),
        route.crossings[first:last],
        route.along[first:last],
    )


def nodes_of(polygon: RefinedPath, part: FreePart, piece: int) -> Array:
    """Return the polygon's values on one piece of a free part, shape (2, nodes)."""
    first = part.first[1] if piece == part.first[0] else 0
    last = part.last[1] if piece == part.last[0] else polygon.values.shape[2] - 1
    return polygon.values[piece, :, first : last + 1]
