"""Paper beyond an edge of a flat piece, as below the hip of a skirt, where the skin is no guide."""

from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.pattern.definitions.panels import Panel
from bodymeasure.pattern.pieces.piece import PieceEdge


def extended(edges: tuple[PieceEdge, ...], panel: Panel, meters: float) -> tuple[PieceEdge, ...]:
    """Return the edges of a piece with the paper that its panel adds.

    The edges beside the one that is extended run on along the grain, or aside of it by the flare;
    the edge itself is moved to their ends. A fold stays straight.

    Parameters
    ----------
    edges : tuple of PieceEdge
        In order round the piece, whose grain points up the second axis.
    panel : Panel
    meters : float
        The length of the atlas's unit.

    Raises
    ------
    InputError
        If the edge has a dart.
    """
    if panel.extend is None:
        return edges
    length, flare = panel.extend.length / meters, panel.extend.flare / meters
    names = [edge.name for edge in edges]
    here = names.index(panel.extend.edge)
    before, after = (here - 1) % len(edges), (here + 1) % len(edges)
    if len(edges[here].parts) > 1:
        raise InputError(
            f"the edge {panel.extend.edge!r} has a dart, so that there is no paper to add beyond "
            "it; let the dart begin on another edge"
        )
    (points,) = edges[here].parts
    every = np.concatenate([part for edge in edges for part in edge.parts])
    # Down from an edge at the bottom, up from one at the top.
    down = np.array([0.0, np.sign(points[:, 1].mean() - every[:, 1].mean()) or -1.0])
    aside = np.sign(points[-1, 0] - points[0, 0]) or 1.0
    # How far each place is from the ends, along the edge.
    part = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    part /= part[-1]
    first = 0.0 if edges[before].name == panel.fold else -flare
    last = 0.0 if edges[after].name == panel.fold else flare
    moved = points + length * down
    moved[:, 0] += aside * (first + (last - first) * part)
    result = [*edges]
    result[before] = _longer(edges[before], tail=np.stack([points[0], moved[0]]))
    result[after] = _longer(edges[after], head=np.stack([moved[-1], points[-1]]))
    hem = float(np.linalg.norm(np.diff(moved, axis=0), axis=1).sum())
    result[here] = replace(edges[here], parts=(moved,), cloth_length=hem)
    return tuple(result)


def _longer(edge: PieceEdge, head: Array | None = None, tail: Array | None = None) -> PieceEdge:
    """Return an edge that begins or ends with a straight line."""
    parts, more = [*edge.parts], 0.0
    if head is not None:
        parts[0] = np.concatenate([head[:-1], parts[0]])
        more += float(np.linalg.norm(head[-1] - head[0]))
    if tail is not None:
        parts[-1] = np.concatenate([parts[-1], tail[1:]])
        more += float(np.linalg.norm(tail[-1] - tail[0]))
    return replace(edge, parts=tuple(parts), cloth_length=edge.cloth_length + more)
