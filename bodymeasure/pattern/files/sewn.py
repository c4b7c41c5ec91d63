"""Whole panels of a garment with what is sewn to what, for programs that simulate cloth.

Pieces on the fold are unfolded, and those of which the other side of the body has its mirror image
get that one, so that the panels go all round the body.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.pattern.definitions.panels import Panel
from bodymeasure.pattern.definitions.seams import is_middle
from bodymeasure.pattern.files.cubics import cubic_chains, part_of
from bodymeasure.pattern.files.places import Place, is_backwards, seam_places
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece

# Points nearer than this, in millimeters, are one.
SAME = 1e-6


@dataclass(frozen=True, eq=False)
class Side:
    """An edge of a panel, or a leg of a dart, from corner to corner.

    Parameters
    ----------
    place : Place
    chain : ndarray, shape (m, 2)
        In millimeters, counterclockwise round the panel.
    """

    place: Place
    chain: Array


@dataclass(frozen=True, eq=False)
class WholePanel:
    """A panel as it is cut: unfolded, or a mirror image.

    Parameters
    ----------
    name : str
    sides : tuple of Side
        Counterclockwise, as seen from outside the body; the first begins where the last ends.
    flat : ndarray, shape (n, 2)
        Points of the panel, in millimeters, and
    skin : ndarray, shape (n, 3)
        where they are on the skin, in millimeters: to the wearer's left, up, and to the front.
    """

    name: str
    sides: tuple[Side, ...]
    flat: Array
    skin: Array


def whole_panels(pattern: Pattern) -> tuple[WholePanel, ...]:
    """Return the panels of a pattern, all round the body."""
    places = seam_places(pattern)
    found = []
    for piece in pattern.pieces:
        alone = not piece.panel.fold and _lacks_other_side(pattern, piece.panel)
        sides = tuple(_sides(pattern, piece, places, alone=alone))
        mirrored = tuple(_mirrored(side) for side in sides[::-1])
        flat, skin = _points(pattern, piece)
        mirrored_flat, mirrored_skin = flat * [-1.0, 1.0], skin * [-1.0, 1.0, 1.0]
        if piece.panel.fold:
            flat = np.concatenate([flat, mirrored_flat])
            skin = np.concatenate([skin, mirrored_skin])
            found.append(WholePanel(piece.name, (*sides, *mirrored), flat, skin))
            continue
        found.append(WholePanel(piece.name, sides, flat, skin))
        if alone:
            other = swapped(piece.name)
            name = other if other != piece.name else f"{piece.name} mirrored"
            found.append(WholePanel(name, mirrored, mirrored_flat, mirrored_skin))
    return tuple(found)


def swapped(words: str) -> str:
    """Return words with left and right exchanged."""
    exchange = {"left": "right", "right": "left"}
    return " ".join(exchange.get(word, word) for word in words.split(" "))


def _sides(
    pattern: Pattern, piece: Piece, places: dict[tuple[str, str], Place], *, alone: bool
) -> Iterator[Side]:
    """Yield the sides of a piece without its fold, beginning after that, counterclockwise.

    Of a piece that comes with its mirror image, an edge in the middle of the body that is sewn to
    nothing else is sewn to that image.
    """
    scale = 1000.0 * pattern.atlas.unit.meters
    edges = [*piece.edges]
    ring = np.concatenate([part for edge in edges for part in edge.parts])
    x, y = ring.T
    # A piece whose atlas faces inwards runs clockwise: it is taken the other way round.
    turned = bool(x @ np.roll(y, -1) < y @ np.roll(x, -1))
    if turned:
        edges = edges[::-1]
    origin = _origin(piece)
    if piece.panel.fold:
        first = [edge.name for edge in edges].index(piece.panel.fold)
        edges = [*edges[first + 1 :], *edges[:first]]
    legs = {}
    for dart in piece.darts:
        for one, other in (dart.legs, dart.legs[::-1]):
            legs[_key(one[0])] = (dart.name, one, other)
    back = is_backwards(piece.panel, [edge.name for edge in piece.edges]) != turned
    own = {edge.name: edge for edge in piece.panel.edge}
    for edge in edges:
        parts = [part[::-1] for part in edge.parts[::-1]] if turned else [*edge.parts]
        whole = places.get((piece.name, edge.name), Place(()))
        if alone and edge.seam and is_middle(own[edge.name]) and not whole.seam:
            whole = Place(("middle", piece.name, edge.name))
        runs_back = whole.runs_back != back
        arcs = np.cumsum([0.0, *(_length(part) for part in parts)]) / edge.length
        if runs_back:
            arcs = 1.0 - arcs
        for number, part in enumerate(parts):
            low, high = (
                whole.start + (whole.end - whole.start) * arc
                for arc in sorted(arcs[number : number + 2].tolist())
            )
            chain = scale * (part - origin)
            yield Side(Place(whole.seam, whole.side, low, high, runs_back), chain)
            if number < len(parts) - 1:
                name, one, other = legs[_key(part[-1])]
                seam = ("dart", piece.name, name)
                yield Side(Place(seam, 0), scale * (one - origin))
                yield Side(Place(seam, 1, runs_back=True), scale * (other[::-1] - origin))


def _origin(piece: Piece) -> Array:
    """Return a point of the fold's line, at which the piece is mirrored."""
    x = piece.edge(piece.panel.fold).parts[0][0, 0] if piece.panel.fold else 0.0
    return np.array([x, 0.0])


def _key(point: Array) -> tuple[float, ...]:
    return tuple(np.round(point, 9).tolist())


def _length(chain: Array) -> float:
    return float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum())


def _mirrored(side: Side) -> Side:
    """Return the mirror image of a side, which runs the other way."""
    seam, row, start, end, runs_back = side.place
    if seam[:1] == ("middle",):
        row = 1
    elif seam:
        seam = (*seam, "mirrored")
    return Side(Place(seam, row, start, end, not runs_back), side.chain[::-1] * [-1.0, 1.0])


def _lacks_other_side(pattern: Pattern, panel: Panel) -> bool:
    """Whether a panel lies on one side of the body, and the set has none on the other side."""
    own = {edge.through for edge in panel.edge}
    mirrored = {tuple(swapped(name) for name in through) for through in own}
    if mirrored == own or mirrored == {through[::-1] for through in own}:
        return False
    others = [{edge.through for edge in each.edge} for each in (p.panel for p in pattern.pieces)]
    return mirrored not in others


def _points(pattern: Pattern, piece: Piece) -> tuple[Array, Array]:
    """Return the vertices of a piece, flat and on the skin, in millimeters."""
    atlas, scale = pattern.atlas, 1000.0 * pattern.atlas.unit.meters
    places = piece.flat.mesh.places
    skin = evaluate(atlas.control_points[places.patch], places.parameters)
    axes = atlas.axes
    frame = np.stack([axes.left_vector, axes.up_vector, axes.front_vector])
    return np.asarray(scale * (piece.positions - _origin(piece))), np.asarray(
        scale * skin @ frame.T
    )


def sewn_cubics(panels: tuple[WholePanel, ...]) -> dict[tuple[int, int], list[Array]]:
    """Return the cubics of each side, by the numbers of panel and side, in the panel's order.

    Sides of one seam are cut at the same fractions, so that their parts are sewn one to one.
    """
    groups: dict[tuple[str, ...], dict[tuple[int, int], Side]] = {}
    for number, panel in enumerate(panels):
        for row, side in enumerate(panel.sides):
            key = side.place.seam or (str(number), str(row))
            groups.setdefault(key, {})[number, row] = side
    found: dict[tuple[int, int], list[Array]] = {}
    for sides in groups.values():
        found |= _cubics_of(sides)
    return found


def _cubics_of(sides: dict[tuple[int, int], Side]) -> dict[tuple[int, int], list[Array]]:
    """Return the cubics of the sides of one seam."""
    ends = sorted({end for side in sides.values() for end in (side.place.start, side.place.end)})
    breaks = [end for row, end in enumerate(ends) if row == 0 or end - ends[row - 1] > SAME]
    found: dict[tuple[int, int], list[Array]] = {member: [] for member in sides}
    for start, end in pairwise(breaks):
        inside = [
            member
            for member, side in sides.items()
            if side.place.start < end - SAME and side.place.end > start + SAME
        ]
        parts = [_between(sides[member], start, end) for member in inside]
        for member, cubics in zip(inside, cubic_chains(parts, (0.0, 1.0)), strict=True):
            found[member] += cubics
    for member, side in sides.items():
        if side.place.runs_back:
            found[member] = [cubic[::-1] for cubic in found[member][::-1]]
    return found


def _between(side: Side, start: float, end: float) -> Array:
    """Return the part of a side between two fractions of its seam, in the seam's direction."""
    chain = side.chain[::-1] if side.place.runs_back else side.chain
    low, size = side.place.start, side.place.end - side.place.start
    return part_of(chain, max(0.0, (start - low) / size), min(1.0, (end - low) / size))
