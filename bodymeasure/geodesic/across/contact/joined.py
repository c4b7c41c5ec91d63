"""The parts of a path that edges hold, and the path that they make."""

from collections.abc import Sequence
from dataclasses import dataclass

from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.geodesic.across.contact.free_leg import FreeLeg
from bodymeasure.geodesic.across.pieces.path import PathPiece
from bodymeasure.geodesic.across.pieces.route_error import RouteLength


@dataclass(frozen=True, eq=False)
class HeldPath:
    """A path, or a part of one, of free legs and arcs along edges.

    Parameters
    ----------
    pieces : tuple of PathPiece
    crossings : tuple of (int, pair of AtlasPoint)
        After which piece a seam is crossed, and the point there on both patches.
    start, end : AtlasPoint
    length : RouteLength
    """

    pieces: tuple[PathPiece, ...]
    crossings: tuple[tuple[int, tuple[AtlasPoint, AtlasPoint]], ...]
    start: AtlasPoint
    end: AtlasPoint
    length: RouteLength


def of_leg(leg: FreeLeg) -> HeldPath:
    """A free leg alone."""
    problem = leg.refined.problem
    route = problem.route
    parts = zip(
        route.patches,
        leg.refined.values,
        (leg.refined.lengths * problem.size).tolist(),
        strict=True,
    )
    return HeldPath(
        pieces=tuple(PathPiece(patch, problem.space, *rest) for patch, *rest in parts),
        crossings=tuple(
            (n, (route.exit(n), route.entry(n + 1))) for n in range(len(route.crossings))
        ),
        start=route.start,
        end=route.end,
        length=leg.length,
    )


def put_together(parts: Sequence[HeldPath]) -> HeldPath:
    """One path of all parts; those of no length are left out."""
    parts = [part for part in parts if part.length.raw > 0.0]
    pieces: list[PathPiece] = []
    crossings: list[tuple[int, tuple[AtlasPoint, AtlasPoint]]] = []
    for number, part in enumerate(parts):
        if number and parts[number - 1].end.patch != part.start.patch:
            crossings.append((len(pieces) - 1, (parts[number - 1].end, part.start)))
        crossings += [(len(pieces) + after, places) for after, places in part.crossings]
        pieces += part.pieces
    lengths = [part.length for part in parts]
    whole = RouteLength(
        raw=sum(length.raw for length in lengths),
        corrected=sum(length.corrected for length in lengths),
        error=sum(length.error for length in lengths),
        residual=max(length.residual for length in lengths),
        trusted=all(length.trusted for length in lengths),
        minimal=all(length.minimal for length in lengths),
    )
    return HeldPath(tuple(pieces), tuple(crossings), parts[0].start, parts[-1].end, whole)
