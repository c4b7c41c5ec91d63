"""The taut tape: the shortest way outside the body between two of its points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.arguments import require_kind
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.queries.approximation_error import approximation_error
from bodymeasure.atlas.queries.locations import Location, listed
from bodymeasure.atlas.queries.outside import Outside
from bodymeasure.atlas.units import Unit
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic import AtlasPath, geodesic_between
from bodymeasure.geodesic.across.search.ends import checked_points
from bodymeasure.geodesic.status import OnFailure, check_on_failure
from bodymeasure.taut.skin import Skin, skin_of
from bodymeasure.taut.solve import TautLeg, draw_taut
from bodymeasure.taut.starts import first_strings
from bodymeasure.taut.status import TautStatus
from bodymeasure.threads import one_blas_thread
from bodymeasure.trust import is_known
from bodymeasure.wording import result_line

# A string that is longer than the path along the skin by more than this part of it has not come to
# rest.
LONGER = 1e-6


@dataclass(frozen=True, eq=False)
class TautTape:
    """A tape drawn taut over a body, and the lengths it is compared with.

    Parameters
    ----------
    length : float
        In `unit`. NaN unless the status has a length. Never below `chord` or above the contact
        path's length.
    raw_length : float
        The length that was found, whatever the status; NaN where none was.
    error_estimate : float
        Estimated error of `raw_length`, in `unit`; infinite where nothing is known.
    status : TautStatus
        The worst of its legs.
    unit : Unit
    points : ndarray, shape (n, 3)
        The tape as a polygon, in order; its corners on the skin are joined by chords.
    normals : ndarray, shape (n, 3)
        Unit vectors out of the body where the tape touches it, 0 where it stands free.
    contact : AtlasPath
        The path along the skin, through the same points.
    chord : float
        Sum of the straight distances from point to point.
    """

    length: float
    raw_length: float
    error_estimate: float
    status: TautStatus
    unit: Unit
    points: Array
    normals: Array
    contact: AtlasPath
    chord: float

    def __repr__(self) -> str:
        kind, unit, status = "TautTape", self.unit, self.status.name
        lengths = {"length": self.length, "chord": self.chord}
        return result_line(kind, unit, self.error_estimate, outcome=status, **lengths)

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate."""
        return approximation_error(self.contact.atlas, self.points)

    @property
    def gap(self) -> float:
        """The length that the taut tape saves over the one that follows the skin."""
        return self.contact.length - self.length

    @property
    def touching(self) -> Bools:
        """Which of the points lie on the skin, shape (n,)."""
        return np.asarray((self.normals != 0.0).any(axis=1))

    @property
    def converged(self) -> bool:
        """Whether the length can be trusted."""
        return self.status.has_length


@one_blas_thread()
def taut_tape(
    atlas: Atlas,
    start: Location,
    end: Location,
    via: Sequence[Location] = (),
    *,
    contact: AtlasPath | None = None,
    outside: Outside = "determined",
    on_failure: OnFailure = "raise",
) -> TautTape:
    """Return the shortest way outside the body between two of its points, and along its skin.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or position of shape (3,)
        A landmark's name, a point of the atlas, or a position in the atlas's unit, for which the
        closest point of the surface is taken.
    via : sequence of the same
        Points at which the tape is held, in order.
    contact : AtlasPath, optional
        The path along the skin through the same points, if it is known already.
    outside : {"determined", "along normals", "against normals"}
        Where the outside is: determined from what the surface encloses, or, for an open surface,
        where S_u x S_v points, or opposite.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, so that no failure is
        overlooked, or say so in the status, with NaN for a length.

    Returns
    -------
    TautTape

    Raises
    ------
    InputError
        If a location is not on the atlas, two are on parts that no seam joins, the outside cannot
        be determined, or `contact` leads through other points or over another atlas.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".

    Notes
    -----
    A string of points starts on the path along the skin and slides to rest, each point kept
    outside the tangent plane at its closest point of the skin: see `bodymeasure.taut.string`. It
    bridges hollows, and lies on the skin everywhere else. Parts that touch the skin are measured as
    arcs over it. The error estimate is the change from a string of half as many points, plus the
    errors of the segments. The tape is the shortest among those nearby: one that goes round the
    body on another side is found from a `contact` that does.

    Beyond an open boundary, such as a trimmed neck, the surface is taken to go on straight.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> tape = bm.taut_tape(body, "bust point left", "bust point right")
    >>> print(f"{tape.chord:.4f} {tape.length:.4f} {tape.contact.length:.4f} {tape.unit}")
    0.2092 0.2104 0.2169 m
    """
    check_on_failure(on_failure)
    if str(outside) not in ("determined", "along normals", "against normals"):
        raise InputError(
            f"outside is {outside!r}; expected 'determined', 'along normals' or 'against normals'"
        )
    via = listed(via, "via")
    names = ("the start", *(f"via point {i}" for i in range(len(via))), "the end")
    # Points a hair off a seam are put on it, as for the path along the skin.
    ends = checked_points(atlas, (start, *via, end), names)
    points = ends.points
    if contact is None:
        contact = geodesic_between(atlas, points[0], points[-1], points[1:-1], on_failure="status")
        contact = contact.with_ends_moved(*ends.moves)
    elif require_kind(contact, AtlasPath, "contact", "an AtlasPath").atlas is not atlas:
        raise InputError("the contact path is one over another atlas; expected this one")
    elif contact.points != points:
        raise InputError(
            f"the contact path leads through {contact.points}, the tape through {points}; expected "
            "the same points in the same order"
        )
    skin = skin_of(atlas, outside)
    strings = first_strings(contact)
    tape = (
        _drawn(skin, contact, strings, 2.0 * sum(ends.moves)) if strings else _without_path(contact)
    )
    if on_failure == "raise" and not tape.converged:
        raise ConvergenceError(tape.status.sentence)
    return tape


def _drawn(skin: Skin, contact: AtlasPath, strings: list[Array], moved: float) -> TautTape:
    legs = [draw_taut(skin, nodes) for nodes in strings]
    chord = _chord(contact)
    raw, error, status = _length_of_tape(contact, legs, chord)
    error += moved
    if status.has_length and not is_known(raw, error, skin.size):
        status = TautStatus.INACCURATE
    length = raw if status.has_length else np.nan
    # The points between legs are in both.
    points = np.concatenate([legs[0].nodes[:1], *(leg.nodes[1:] for leg in legs)])
    normals = np.concatenate([legs[0].normals[:1], *(leg.normals[1:] for leg in legs)])
    unit = contact.atlas.unit
    return TautTape(length, raw, error, status, unit, points, normals, contact, chord)


def _length_of_tape(
    contact: AtlasPath, legs: list[TautLeg], chord: float
) -> tuple[float, float, TautStatus]:
    length, error = sum(leg.length for leg in legs), sum(leg.error for leg in legs)
    along = contact.length if contact.converged else contact.raw_length
    # Where there is no path along the skin, nothing bounds the length from above.
    along = along if contact.pieces else np.inf
    known = contact.error_estimate if contact.converged else 0.0
    settled = all(leg.settled for leg in legs)
    if not settled or length > (1.0 + LONGER) * along + error + known:
        return np.nan, np.inf, TautStatus.NOT_CONVERGED
    # What lies outside these bounds is within the errors.
    bounded = float(min(max(length, chord), along))
    status = TautStatus.CONVERGED if contact.converged else TautStatus.WITHOUT_CONTACT
    return bounded, float(error + abs(length - bounded)), status


def _without_path(contact: AtlasPath) -> TautTape:
    nothing = np.zeros((0, 3))
    return TautTape(
        np.nan,
        np.nan,
        np.inf,
        TautStatus.NO_PATH,
        contact.atlas.unit,
        nothing,
        nothing,
        contact,
        _chord(contact),
    )


def _chord(contact: AtlasPath) -> float:
    positions = np.array([contact.atlas.position(point) for point in contact.points])
    return float(np.linalg.norm(np.diff(positions, axis=0), axis=1).sum())
