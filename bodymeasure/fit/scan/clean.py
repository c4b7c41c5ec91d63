"""A mesh as a file has it made into a scan: welded, oriented, without small pieces and plates."""

import itertools
from typing import NamedTuple, Self

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.fit.scan.load import Triangles
from bodymeasure.fit.scan.orient import oriented
from bodymeasure.fit.scan.plates import LEAST_AREA as LEAST_FLAT
from bodymeasure.fit.scan.plates import plates
from bodymeasure.fit.scan.weld import area_vectors, pieces, used_only, welded
from bodymeasure.wording import counted

# Pieces with less than this part of the area are hair, markers and specks.
SMALL = 0.03
# A piece of which this part lies on a plate is one, and a piece that lies so far inside others is
# the inner side of a hollow body.
MOSTLY = 0.9
# In meters: a body of 1.35 to 2.1 m without its head or its feet is longer, and one with spread
# arms shorter.
LENGTHS = (1.0, 3.0)
# The same with a room around it, or damaged places far away.
WIDELY = (0.3, 30.0)
# In square meters: the smallest bodies have twice as much.
LEAST_AREA = 0.5
# Pieces with at least this part of the area each may be several people, if their middles are at
# least so many meters apart across their length; the halves of one body are closer.
ONE_OF_SEVERAL, APART = 0.2, 0.4
# Triangles that are tried for whether a piece lies inside others, and how far outside them.
_TRIED, _OUTSIDE = 500, 1e-4


class _Mesh(NamedTuple):
    """A mesh with the area and the piece of each triangle, which are counted once."""

    vertices: Array
    triangles: Ints
    area: Array
    piece: Ints

    @classmethod
    def of(cls, vertices: Array, triangles: Ints) -> Self:
        area = np.linalg.norm(area_vectors(vertices, triangles), axis=1)
        return cls(vertices, triangles, area, pieces(vertices, triangles))

    def only(self, kept: Bools) -> Self:
        """Return the mesh with some of its triangles; its pieces are counted anew."""
        if kept.all():
            return self
        vertices, triangles = used_only(self.vertices, self.triangles[kept])
        number = np.unique(self.piece[kept], return_inverse=True)[1].astype(np.int64)
        return type(self)(vertices, triangles, self.area[kept], number)


def cleaned(found: Triangles, unit: Unit) -> tuple[Triangles, Bools]:
    """Return the mesh of a body in meters, and which of its triangles may belong to a plate.

    Parameters
    ----------
    found : Triangles
        In meters.
    unit : Unit
        The unit that the user gave, for messages.

    Raises
    ------
    InputError
        If nothing is left that has the size of a body.
    """
    _require_length(found.vertices[np.isfinite(found.vertices).all(axis=1)], unit, WIDELY)
    vertices, triangles, notes = welded(found)
    more = list(notes)
    mesh = _Mesh.of(vertices, triangles)
    mesh = mesh.only(_large(mesh, more))
    mesh = mesh._replace(triangles=_turned_outwards(mesh, more))
    mesh = mesh.only(~_inside_others(mesh, more))
    _require_length(mesh.vertices, unit, LENGTHS)
    _require_one(mesh)
    plate = plates(mesh.vertices, mesh.triangles)
    kept = _without_plates(mesh, plate, more)
    mesh = mesh.only(kept)
    return Triangles(mesh.vertices, mesh.triangles, tuple(more)), plate[kept]


def _large(mesh: _Mesh, notes: list[str]) -> Bools:
    """Return which triangles belong to pieces that are not small."""
    share = np.bincount(mesh.piece, mesh.area) / mesh.area.sum()
    large = share >= SMALL
    if not large.any():
        raise InputError(
            f"falls into {len(share):,} pieces, of which none has {SMALL:.0%} of the area; "
            "expected a connected surface: close the gaps between the triangles, for example with "
            "MeshLab's Merge Close Vertices"
        )
    if not large.all():
        notes.append(
            f"Dropped {counted(int((~large).sum()), 'small piece')}, together "
            f"{100.0 * share[~large].sum():.2g} % of the area."
        )
    if large.sum() > 1:
        notes.append(f"The mesh is in {large.sum()} pieces.")
    return np.asarray(large[mesh.piece])


def _turned_outwards(mesh: _Mesh, notes: list[str]) -> Ints:
    result, part, turned = oriented(mesh.vertices, mesh.triangles)
    if turned.any():
        whole = np.bincount(part, turned) == np.bincount(part)
        many = part.max() + 1
        if whole.all():
            notes.append("The mesh was inside out: turned all of its triangles round.")
        elif whole.any():
            notes.append(
                f"Turned {counted(int(whole.sum()), 'part')} of {many} right side out, "
                f"{mesh.area[whole[part]].sum() / mesh.area.sum():.1%} of the area."
            )
        single = turned & ~whole[part]
        if single.any():
            notes.append(
                f"Turned {counted(int(single.sum()), 'triangle')} round to agree with their "
                "neighbors."
            )
    return result


def _inside_others(mesh: _Mesh, notes: list[str]) -> Bools:
    """Return which triangles belong to pieces that lie inside others."""
    vertices, triangles, _, piece = mesh
    result = np.zeros(len(triangles), dtype=np.bool_)
    if piece.max() == 0:
        return result
    import igl  # orienting has found it

    areas = area_vectors(vertices, triangles)
    outside = areas / np.linalg.norm(areas, axis=1)[:, None] * _OUTSIDE
    places = vertices[triangles].mean(axis=1) + outside
    for one in range(piece.max() + 1):
        members = np.flatnonzero(piece == one)
        tried = members[:: max(1, len(members) // _TRIED)]
        others = np.ascontiguousarray(triangles[piece != one])
        winding = igl.fast_winding_number(vertices, others, np.ascontiguousarray(places[tried]))
        if np.mean(winding > 0.5) >= MOSTLY:
            result[members] = True
    if result.any():
        inner = len(np.unique(piece[result]))
        notes.append(f"Dropped {counted(inner, 'piece')} inside the others, as of a hollow body.")
    return result


def _require_length(vertices: Array, unit: Unit, lengths: tuple[float, float]) -> None:
    """Refuse a mesh that is no body in the given unit; the message says in which it would be."""
    low, high = np.percentile(vertices, [1.0, 99.0], axis=0) if len(vertices) else np.zeros((2, 1))
    length = float((high - low).max())
    if lengths[0] <= length <= lengths[1]:
        return
    size = length / unit.meters
    fitting = [other.value for other in Unit if LENGTHS[0] <= size * other.meters <= LENGTHS[1]]
    remedy = (
        f"in {' or '.join(fitting)} it would be; check the unit of the file (file_unit=... in "
        "Python, --file-unit on the command line)"
        if fitting
        else "check the unit of the file, and give the mesh of a whole body"
    )
    raise InputError(
        f"is {length:.3g} m long in the unit {unit}, and a body {LENGTHS[0]:g} to "
        f"{LENGTHS[1]:g} m; {remedy}"
    )


def _require_one(mesh: _Mesh) -> None:
    """Refuse pieces of the size of bodies that stand side by side."""
    shares = np.bincount(mesh.piece, mesh.area) / mesh.area.sum()
    if (shares >= ONE_OF_SEVERAL).sum() < 2:
        return
    large = [
        mesh.vertices[mesh.triangles[mesh.piece == one]].reshape(-1, 3)
        for one in np.flatnonzero(shares >= ONE_OF_SEVERAL)
    ]
    for first, second in itertools.combinations(large, 2):
        long = np.minimum(np.ptp(first, axis=0), np.ptp(second, axis=0)) >= LENGTHS[0]
        step = first.mean(axis=0) - second.mean(axis=0)
        apart = np.sqrt(step @ step - step**2)
        if (long & (apart >= APART)).any():
            raise InputError(
                f"holds {len(large)} pieces of the size of a body, two of them "
                f"{apart[long].max():.2g} m apart; expected one person: cut the others away, or "
                "save each in a file of its own"
            )


def _without_plates(mesh: _Mesh, plate: Bools, notes: list[str]) -> Bools:
    """Return which triangles belong to pieces that are no plates; soles are taken off `plate`."""
    area, piece = mesh.area, mesh.piece
    if area[~plate].sum() < LEAST_AREA:
        raise InputError(
            f"has {area[~plate].sum():.2g} m² beside its flat sides; expected the mesh of a body, "
            f"which has more than {LEAST_AREA:g} m²"
        )
    flat = np.bincount(piece, area * plate) >= MOSTLY * np.bincount(piece, area)
    if flat.any():
        notes.append(
            f"Dropped {counted(int(flat.sum()), 'flat piece')}, as a floor, "
            f"{area[flat[piece]].sum() / area.sum():.0%} of the area."
        )
    joined = plate & ~flat[piece]
    if area[joined].sum() < LEAST_FLAT:
        # They are the soles that stood on a plate.
        plate[joined] = False
    elif joined.any():
        notes.append(
            f"Took {area[joined].sum() / area.sum():.0%} of the area for a floor or a stool, and "
            "not for the body."
        )
    return np.asarray(~flat[piece])
