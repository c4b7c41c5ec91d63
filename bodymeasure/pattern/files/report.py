"""The report of a pattern as JSON: pieces, edges, darts, seams and warnings, in millimeters."""

import msgspec
import numpy as np

from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.pieces.piece import Piece


class EdgeRecord(msgspec.Struct, frozen=True, kw_only=True):
    """An edge of a piece; lengths are in millimeters."""

    name: str
    seam: str
    length_on_skin: float
    length_on_cloth: float
    length_in_piece: float


class DartRecord(msgspec.Struct, frozen=True, kw_only=True):
    """A dart of a piece; lengths are in millimeters, the angle in degrees."""

    name: str
    edge: str
    length: float
    intake: float
    angle: float


class PieceRecord(msgspec.Struct, frozen=True, kw_only=True):
    """A piece; strains are in percent, the area in square centimeters."""

    name: str
    cut: str
    fold: str
    area: float
    rms_strain: float
    strain_95: float
    largest_strain: float
    flipped_triangles: int
    outline_is_simple: bool
    settled: bool
    edges: tuple[EdgeRecord, ...]
    darts: tuple[DartRecord, ...]


class SeamRecord(msgspec.Struct, frozen=True, kw_only=True):
    """Edges that are sewn together, several in a row with a plus; lengths are in millimeters."""

    name: str
    pieces: tuple[str, str]
    edges: tuple[str, str]
    lengths: tuple[float, float]
    difference: float
    ease: float


class PatternRecord(msgspec.Struct, frozen=True, kw_only=True):
    """A pattern; its ease is that of girths by their levels, in millimeters."""

    schema: str = "bodymeasure pattern report 1"
    body: str
    digest: str
    set: str
    unit: str = "mm"
    allowance: float
    ease: dict[str, float]
    bridge: bool
    pieces: tuple[PieceRecord, ...]
    seams: tuple[SeamRecord, ...]
    warnings: tuple[str, ...]


def pattern_record(pattern: Pattern, *, allowance: float = 10.0) -> PatternRecord:
    """Return what a report says of a pattern; the allowance is in millimeters."""
    scale = 1000.0 * pattern.atlas.unit.meters
    return PatternRecord(
        body=pattern.atlas.name,
        digest=pattern.atlas.digest,
        set=pattern.definitions.name,
        allowance=allowance,
        ease={level: 1000.0 * girth for level, girth in pattern.ease.items()},
        bridge=pattern.bridge,
        pieces=tuple(_piece(piece, scale) for piece in pattern.pieces),
        seams=tuple(
            SeamRecord(
                name=seam.name,
                pieces=seam.pieces,
                edges=seam.edges,
                lengths=(scale * seam.lengths[0], scale * seam.lengths[1]),
                difference=scale * seam.difference,
                ease=scale * seam.ease,
            )
            for seam in pattern.seams
        ),
        warnings=pattern.warnings,
    )


def pattern_json(pattern: Pattern, *, allowance: float = 10.0) -> bytes:
    """Return the report of a pattern as JSON; every number round-trips."""
    record = pattern_record(pattern, allowance=allowance)
    return msgspec.json.format(msgspec.json.encode(record), indent=1) + b"\n"


def _piece(piece: Piece, scale: float) -> PieceRecord:
    area = piece.flat.stretch.area
    largest = np.abs(piece.strains).max(axis=1)
    order = np.argsort(largest)
    share = np.cumsum(area[order]) / area.sum()
    return PieceRecord(
        name=piece.name,
        cut=piece.panel.cut,
        fold=piece.panel.fold,
        area=float(area.sum()) * scale**2 / 100.0,
        rms_strain=100.0 * piece.rms_strain,
        strain_95=100.0 * float(largest[order][np.searchsorted(share, 0.95)]),
        largest_strain=100.0 * float(largest.max()),
        flipped_triangles=piece.flips,
        outline_is_simple=piece.is_simple,
        settled=piece.flat.converged,
        edges=tuple(
            EdgeRecord(
                name=edge.name,
                seam=edge.seam,
                length_on_skin=scale * edge.skin_length,
                length_on_cloth=scale * edge.cloth_length,
                length_in_piece=scale * edge.length,
            )
            for edge in piece.edges
        ),
        darts=tuple(
            DartRecord(
                name=dart.name,
                edge=dart.edge,
                length=scale * dart.length,
                intake=scale * dart.intake,
                angle=dart.angle,
            )
            for dart in piece.darts
        ),
    )
