"""A flat piece: what it measures, and how much its cloth has to give."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.definitions.panels import Panel
from bodymeasure.pattern.flat.flatten import Flat
from bodymeasure.pattern.planar import shapely


@dataclass(frozen=True, eq=False)
class PieceEdge:
    """An edge of a flat piece.

    Parameters
    ----------
    name : str
    seam : str
        The seam to which it is sewn; empty if none was named.
    parts : tuple of ndarray, shape (m, 2)
        Its vertices in the piece, one chain more than there are darts on it.
    skin_length : float
        Its length on the skin.
    cloth_length : float
        Its length on the cloth above the skin, with the paper that is added beyond it, which it has
        to have in the piece; that on the skin where there is neither ease nor such paper.
    ease : float
        By how much it is longer than the curve, to be eased or gathered into the seam.
    """

    name: str
    seam: str
    parts: tuple[Array, ...]
    skin_length: float
    cloth_length: float
    ease: float = 0.0

    @property
    def length(self) -> float:
        """Its length in the piece, without the mouths of darts."""
        return float(sum(np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in self.parts))


@dataclass(frozen=True, eq=False)
class PieceDart:
    """A dart of a flat piece.

    Parameters
    ----------
    name : str
    edge : str
    legs : tuple of ndarray, shape (m, 2)
        Both legs from their feet to the tip.
    length : float
        The length of each leg.
    """

    name: str
    edge: str
    legs: tuple[Array, Array]
    length: float

    @property
    def intake(self) -> float:
        """The distance of both feet."""
        return float(np.linalg.norm(self.legs[0][0] - self.legs[1][0]))

    @property
    def angle(self) -> float:
        """The angle at the tip between the chords of both legs, in degrees."""
        return dart_angle(self.legs[0], self.legs[1])


def dart_angle(before: Array, after: Array) -> float:
    """Return the angle in degrees by which a dart opens; negative where its legs overlap."""
    one, other = before[0] - before[-1], after[0] - after[-1]
    turn = one[0] * other[1] - one[1] * other[0]
    return float(np.degrees(np.arctan2(turn, one @ other)))


@dataclass(frozen=True, eq=False)
class Piece:
    """A flat piece, in the atlas's unit.

    Parameters
    ----------
    panel : Panel
    flat : Flat
        The mesh that was laid flat.
    positions : ndarray, shape (n, 2)
        Its vertices in the piece, grain up, as seen from outside the body.
    edges : tuple of PieceEdge
        In order round the piece.
    darts : tuple of PieceDart
    outline : ndarray, shape (m, 2)
        The border, legs of darts included.
    warnings : tuple of str
    """

    panel: Panel
    flat: Flat
    positions: Array
    edges: tuple[PieceEdge, ...]
    darts: tuple[PieceDart, ...]
    outline: Array
    warnings: tuple[str, ...]

    @property
    def name(self) -> str:
        """The panel's name."""
        return self.panel.name

    @property
    def strains(self) -> Array:
        """The principal strains of each triangle, the larger one first, shape (k, 2)."""
        return self.flat.stretch.strains(self.flat.positions)

    @property
    def rms_strain(self) -> float:
        """The root mean square of the principal strains over the piece."""
        area = self.flat.stretch.area
        return float(np.sqrt(area @ (self.strains**2).mean(axis=1) / area.sum()))

    @property
    def lift(self) -> float:
        """How far at most the cloth is from its place on the body where it bridges hollows."""
        return float(self.flat.mesh.lift.max())

    @property
    def flips(self) -> int:
        """The number of triangles that lie on their faces."""
        return int(self.flat.stretch.flipped(self.flat.positions).sum())

    @property
    def is_simple(self) -> bool:
        """Whether the outline does not cross itself."""
        return bool(shapely.is_valid(shapely.polygons(self.outline)))

    @property
    def is_sound(self) -> bool:
        """Whether it settled, does not flip, and has an outline that does not cross itself."""
        return self.flat.converged and not self.flips and self.is_simple

    def edge(self, name: str) -> PieceEdge:
        """Return the edge of a name."""
        return next(edge for edge in self.edges if edge.name == name)

    def __repr__(self) -> str:
        return f"<Piece {self.name!r}: strain {100.0 * self.rms_strain:.2f} %>"


def outline_of(edges: tuple[PieceEdge, ...], darts: tuple[PieceDart, ...]) -> Array:
    """Return the border of a piece, legs of darts included; both come in order round it."""
    rows, left = [], iter(darts)
    for edge in edges:
        for number, part in enumerate(edge.parts):
            rows.append(part[:-1])
            if number < len(edge.parts) - 1:
                before, after = next(left).legs
                rows += [before[:-1], after[:0:-1]]
    return np.concatenate(rows)
