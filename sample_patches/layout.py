"""The layout of a mannequin's patches: strips of patches, and the limbs that rings of them form."""

from collections.abc import Container
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, edge_table
from bodymeasure.bezier import evaluate

Step = tuple[int, int]
"""A patch, and the number of its side (in the order of `bodymeasure.atlas.EDGES`)."""

PLACES = ("outer", "front", "inner", "back")


class LayoutError(Exception):
    """The layout is not one that the rule for names understands."""


class Layout:
    """The neighbors and positions of the patches of an atlas.

    `centers` are positions (patches, 3); `to_left` and `to_front` their components.
    """

    def __init__(self, atlas: Atlas) -> None:
        self.atlas = atlas
        self.centers = evaluate(atlas.control_points, np.full((len(atlas), 2), 0.5))
        self.to_left = self.centers @ atlas.axes.left_vector
        self.to_front = self.centers @ atlas.axes.front_vector
        self._table = edge_table(atlas.index)
        by_edge: dict[int, list[Step]] = {}
        for patch, edges in enumerate(self._table.edge.tolist()):
            for side, edge in enumerate(edges):
                by_edge.setdefault(edge, []).append((patch, side))
        self._twin = {
            here: there
            for sides in by_edge.values()
            if len(sides) == 2
            for here, there in (sides, sides[::-1])
        }
        self.boundary: list[Step] = [sides[0] for sides in by_edge.values() if len(sides) == 1]

    def across(self, step: Step) -> Step | None:
        """The patch beyond a side, with the side opposite to the shared one."""
        twin = self._twin.get(step)
        # EDGES lists opposite sides in pairs: 0 and 1, 2 and 3.
        return None if twin is None else (twin[0], twin[1] ^ 1)

    def strip(self, step: Step) -> list[Step]:
        """The patches of a straight walk, each with the side that leaves it.

        Begins with the given patch; ends at the boundary, or before it closes.
        """
        strip = [step]
        while (following := self.across(strip[-1])) is not None and following != strip[0]:
            strip.append(following)
        return strip

    def ends(self, step: Step) -> Array:
        """Positions of a side's two ends, shape (2, 3)."""
        numbers = self._table.control_index[step][[0, 3]]
        return np.asarray(self.atlas.points[numbers])

    def left_side(self, step: Step) -> Step:
        """The side farther to the wearer's left of the two beside the one given."""
        sides = ((2, 3), (0, 1))[step[1] // 2]
        left = self.atlas.axes.left_vector
        return max(
            ((step[0], side) for side in sides),
            key=lambda candidate: float((self.ends(candidate) @ left).sum()),
        )

    def landmark(self, name: str) -> Array:
        """Position of a landmark, shape (3,)."""
        return self.atlas.position(self.atlas.landmarks[name])

    def boundary_loops(self) -> tuple[list[Step], list[Step], list[Step]]:
        """Boundary sides round the neck, the left wrist and the left ankle."""
        loops: list[tuple[set[int], list[Step]]] = []
        for step in self.boundary:
            corners = set(self._table.control_index[step][[0, 3]].tolist())
            joined = [loop for loop in loops if loop[0] & corners]
            loops = [loop for loop in loops if not loop[0] & corners]
            loops.append(
                (
                    corners.union(*(loop[0] for loop in joined)),
                    [step, *(other for loop in joined for other in loop[1])],
                )
            )
        # From top to bottom, without those of the right half.
        up = self.atlas.axes.up_vector
        found = [
            sides for _, sides in loops if max(self.to_left[patch] for patch, _ in sides) > 0.0
        ]
        found.sort(key=lambda sides: -float(np.mean([self.centers[p] @ up for p, _ in sides])))
        if len(found) != 3:
            raise LayoutError(f"{len(found)} openings; expected neck, left wrist, left ankle")
        return found[0], found[1], found[2]


@dataclass(frozen=True)
class Limb:
    """Strips along a limb, by their place round it (``outer``, ``front inner``, ...).

    Each runs from the limb's end towards the body and on into the trunk; the first `length`
    patches of each belong to the limb.
    """

    columns: dict[str, list[Step]]
    length: int

    def ring(self, row: int) -> dict[str, Step]:
        """The patches round the limb by place; row 0 is the one next to the body."""
        return {place: column[self.length - 1 - row] for place, column in self.columns.items()}

    def into_trunk(self, place: str) -> list[Step]:
        """The rest of a strip, past the limb."""
        return self.columns[place][self.length :]


def limb(layout: Layout, end: list[Step], *, beyond: int) -> Limb:
    """The limb that ends at a boundary loop.

    Parameters
    ----------
    layout : Layout
    end : list of Step
        The boundary loop's sides.
    beyond : int
        Patches of each strip that belong to the limb past its last closed ring.
    """
    columns = [layout.strip((patch, side ^ 1)) for patch, side in end]
    rings = 0
    while _is_ring(layout, [column[rings] for column in columns]):
        rings += 1
    centers = np.array([[layout.centers[column[i][0]] for column in columns] for i in range(rings)])
    places = _places(layout, centers)
    return Limb(dict(zip(places, columns, strict=True)), rings + beyond)


def until(strip: list[Step], stop: Container[int]) -> list[Step]:
    """The beginning of a strip, before the first patch that is in `stop`."""
    for i, (patch, _) in enumerate(strip):
        if patch in stop:
            return strip[:i]
    return strip


def _is_ring(layout: Layout, steps: list[Step]) -> bool:
    round_limb = layout.strip(layout.left_side(steps[0]))
    return {patch for patch, _ in round_limb} == {patch for patch, _ in steps}


def _places(layout: Layout, centers: Array) -> list[str]:
    """Places of strips round a limb, from their patches' centers (rings, strips, 3)."""
    middle = centers.mean(axis=1)
    axis = middle[0] - middle[-1]
    axis /= np.linalg.norm(axis)
    front = layout.atlas.axes.front_vector
    front = front - (front @ axis) * axis
    outer = np.cross(front, axis)
    outer *= np.sign(outer @ layout.atlas.axes.left_vector)
    offset = (centers - middle[:, None]).mean(axis=0)
    angle = np.arctan2(offset @ front, offset @ outer)
    quarter = np.round(angle / (np.pi / 2)).astype(int) % 4
    result = [""] * len(angle)
    for i, place in enumerate(PLACES):
        inside = np.flatnonzero(quarter == i)
        # Two in one quarter are distinguished by the direction across it.
        across, words = ((outer, PLACES[::2]), (front, PLACES[1::2]))[(i + 1) % 2]
        ordered = inside[np.argsort(-(offset[inside] @ across))]
        suffixes = {0: [], 1: [""], 2: [f" {word}" for word in words]}.get(len(inside))
        if suffixes is None:
            raise LayoutError(f"{len(inside)} strips on one side of a limb; expected 1 or 2")
        for strip, suffix in zip(ordered, suffixes, strict=True):
            result[strip] = place + suffix
    return result
