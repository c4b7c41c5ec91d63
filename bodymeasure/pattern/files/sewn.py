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
from bodymeasure.pattern.files.cubics import cubic_chains, part_of
from bodymeasure.pattern.files.marks import is_backwards
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece

# Points nearer than this, in millimeters, are one.
SAME = 1e-6


@dataclass(frozen=True, eq=False)
class Side:
    """An edge of a panel, or a leg of a dart, from corner to corner.

    Parameters
    ----------
    name : str
    seam : tuple of str
        What is sewn together has this in common; empty if it is sewn to nothing.
    chain : ndarray, shape (m, 2)
        In millimeters, counterclockwise round the panel.
    breaks : tuple of float
        Fractions of its seam at which it begins and ends, in the seam's direction.
    runs_back : bool
        Whether the seam's direction is the other one.
    """

    name: str
    seam: tuple[str, ...]
    chain: Array
    breaks: tuple[float, float] = (0.0, 1.0)
    runs_back: bool = False


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
    found = []
    for piece in pattern.pieces:
        sides = tuple(_sides(pattern, piece))
        flat, skin = _points(pattern, piece)
        name = piece.name
        if piece.panel.fold:
            mirrored = tuple(_mirrored(side, "other ") for side in sides[::-1])
            both = (1.0, -1.0)
            found.append(
                WholePanel(
                    name,
                    (*sides, *mirrored),
                    np.concatenate([flat * [sign, 1.0] for sign in both]),
                    np.concatenate([skin * [sign, 1.0, 1.0] for sign in both]),
                )
            )
            continue
        found.append(WholePanel(name, sides, flat, skin))
        if _lacks_other_side(pattern, piece.panel):
            mirrored = tuple(_mirrored(side, "") for side in sides[::-1])
            other = swapped(name) if swapped(name) != name else f"{name} mirrored"
            found.append(WholePanel(other, mirrored, flat * [-1.0, 1.0], skin * [-1.0, 1.0, 1.0]))
    return tuple(found)


def swapped(words: str) -> str:
    """Return words with left and right exchanged."""
    exchange = {"left": "right", "right": "left"}
    return " ".join(exchange.get(word, word) for word in words.split(" "))


def _sides(pattern: Pattern, piece: Piece) -> Iterator[Side]:
    """Yield the sides of a piece without its fold, beginning after that, counterclockwise."""
    scale = 1000.0 * pattern.atlas.unit.meters
    edges = [*piece.edges]
    ring = np.concatenate([part for edge in edges for part in edge.parts])
    x, y = ring.T
    # A piece whose atlas faces inwards runs clockwise: it is taken the other way round.
    turned = bool(x @ np.roll(y, -1) < y @ np.roll(x, -1))
    if turned:
        edges = edges[::-1]
    names = [edge.name for edge in edges]
    origin = np.zeros(2)
    if piece.panel.fold:
        first = names.index(piece.panel.fold)
        origin = np.array([edges[first].parts[0][0, 0], 0.0])
        edges = [*edges[first + 1 :], *edges[:first]]
    legs = {}
    for dart in piece.darts:
        for one, other in (dart.legs, dart.legs[::-1]):
            legs[_key(one[0])] = (dart.name, one, other)
    back = is_backwards(piece.panel, [edge.name for edge in piece.edges]) != turned
    for edge in edges:
        parts = [part[::-1] for part in edge.parts[::-1]] if turned else [*edge.parts]
        seam, against = _seam(piece.panel, edge.name)
        runs_back = back != against
        arcs = np.cumsum([0.0, *(_length(part) for part in parts)]) / edge.length
        for number, part in enumerate(parts):
            breaks = float(arcs[number]), float(arcs[number + 1])
            if runs_back:
                breaks = 1.0 - breaks[1], 1.0 - breaks[0]
            chain = scale * (part - origin)
            yield Side(edge.name, seam, chain, breaks, runs_back)
            if number < len(parts) - 1:
                name, one, other = legs[_key(part[-1])]
                dart_seam = ("dart", piece.name, name)
                yield Side(name, dart_seam, scale * (one - origin))
                yield Side(name, dart_seam, scale * (other[::-1] - origin), runs_back=True)


def _key(point: Array) -> tuple[float, ...]:
    return tuple(np.round(point, 9).tolist())


def _length(chain: Array) -> float:
    return float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum())


def _seam(panel: Panel, name: str) -> tuple[tuple[str, ...], bool]:
    """Return what sides of a seam have in common, and whether an edge runs against the seam.

    A seam on the left of the body is another one than its mirror image on the right.
    """
    edge = next((edge for edge in panel.edge if edge.name == name), None)
    if edge is None or not edge.seam:
        return (), False
    return _common(edge.seam, edge.through), edge.through[0] > edge.through[-1]


def _common(seam: str, through: tuple[str, ...]) -> tuple[str, ...]:
    words = {word for landmark in through for word in landmark.split(" ")}
    return ("seam", seam, *sorted(words & {"left", "right"}))


def _mirrored(side: Side, more: str) -> Side:
    """Return the mirror image of a side, which runs the other way."""
    kind = side.seam[:1]
    seam = tuple(swapped(word) for word in side.seam[1:])
    if kind == ("dart",):
        seam = (*seam, "mirrored")
    return Side(
        f"{more}{side.name}",
        (*kind, *seam),
        side.chain[::-1] * [-1.0, 1.0],
        side.breaks,
        not side.runs_back,
    )


def _lacks_other_side(pattern: Pattern, panel: Panel) -> bool:
    """Whether a panel lies on one side of the body, and the set has none on the other side."""
    own = {edge.through for edge in panel.edge}
    mirrored = {tuple(swapped(name) for name in through) for through in own}
    if mirrored == own or mirrored == {through[::-1] for through in own}:
        return False
    others = [{edge.through for edge in each.edge} for each in pattern.definitions.panel]
    return mirrored not in others


def _points(pattern: Pattern, piece: Piece) -> tuple[Array, Array]:
    """Return the vertices of a piece, flat and on the skin, in millimeters."""
    atlas, scale = pattern.atlas, 1000.0 * pattern.atlas.unit.meters
    places = piece.flat.mesh.places
    skin = evaluate(atlas.control_points[places.patch], places.parameters)
    axes = atlas.axes
    frame = np.stack([axes.left_vector, axes.up_vector, axes.front_vector])
    origin = np.zeros(2)
    if piece.panel.fold:
        origin[0] = piece.edge(piece.panel.fold).parts[0][0, 0]
    return np.asarray(scale * (piece.positions - origin)), np.asarray(scale * skin @ frame.T)


def sewn_cubics(panels: tuple[WholePanel, ...]) -> dict[tuple[int, int], list[Array]]:
    """Return the cubics of each side, by the numbers of panel and side, in the panel's order.

    Sides of one seam are cut at the same lengths, so that their parts are sewn one to one.
    """
    groups: dict[tuple[str, ...], list[tuple[int, int]]] = {}
    for number, panel in enumerate(panels):
        for place, side in enumerate(panel.sides):
            key = side.seam or (str(number), str(place))
            groups.setdefault(key, []).append((number, place))
    found: dict[tuple[int, int], list[Array]] = {}
    for members in groups.values():
        found |= _cubics_of(panels, members)
    return found


def _cubics_of(
    panels: tuple[WholePanel, ...], members: list[tuple[int, int]]
) -> dict[tuple[int, int], list[Array]]:
    """Return the cubics of the sides of one seam."""
    sides = {member: panels[member[0]].sides[member[1]] for member in members}
    breaks = sorted({value for side in sides.values() for value in side.breaks})
    breaks = [
        value for row, value in enumerate(breaks) if row == 0 or value - breaks[row - 1] > SAME
    ]
    found: dict[tuple[int, int], list[Array]] = {member: [] for member in members}
    for start, end in pairwise(breaks):
        inside = [
            member
            for member, side in sides.items()
            if side.breaks[0] < end - SAME and side.breaks[1] > start + SAME
        ]
        parts = [_between(sides[member], start, end) for member in inside]
        for member, cubics in zip(inside, cubic_chains(parts, (0.0, 1.0)), strict=True):
            found[member] += cubics
    for member, side in sides.items():
        if side.runs_back:
            found[member] = [cubic[::-1] for cubic in found[member][::-1]]
    return found


def _between(side: Side, start: float, end: float) -> Array:
    """Return the part of a side between two fractions of its seam, in the seam's direction."""
    chain = side.chain[::-1] if side.runs_back else side.chain
    low, high = side.breaks
    return part_of(
        chain, max(0.0, (start - low) / (high - low)), min(1.0, (end - low) / (high - low))
    )
