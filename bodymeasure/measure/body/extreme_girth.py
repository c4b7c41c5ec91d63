"""The largest or smallest girth over a stretch of the body."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Literal

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.errors import InputError
from bodymeasure.measure.body.girths import Girth, girth_of_loop, limb_axis, section_loop
from bodymeasure.section import Plane, SectionLoop, convex_hull
from bodymeasure.threads import one_blas_thread

# The number of planes that are tried before Brent's method narrows down between the best one's
# neighbors: bodies have at most one bulge or hollow in a sixteenth of any stretch over which a tape
# is drawn.
SAMPLES = 17
# The place is found to within this part of the stretch. The girth is flat there, and so exact
# except for rounding.
TOLERANCE = 1e-7


class Extremum(StrEnum):
    """The part of the stretch in which the extreme girth lies."""

    INSIDE = "inside the stretch"
    AT_START = "at the start of the stretch: a more extreme girth may lie beyond; start farther out"
    AT_END = "at the end of the stretch: a more extreme girth may lie beyond; end farther out"


@dataclass(frozen=True, eq=False)
class ExtremeGirth:
    """An extreme girth and where it is.

    Parameters
    ----------
    girth : Girth
    fraction : float
        Fraction of the way from the start of the stretch to its end.
    height : float
        Height of the plane's point along the atlas's way up, in the atlas's unit.
    status : Extremum
    """

    girth: Girth
    fraction: float
    height: float
    status: Extremum

    def __repr__(self) -> str:
        unit = self.girth.unit
        place = f"at height {self.height:.6g} {unit}, {self.status.name}"
        return f"<ExtremeGirth {place}: {self.girth!r}>"


@one_blas_thread()
def extreme_girth(
    atlas: Atlas,
    start: Location,
    end: Location,
    kind: Literal["largest", "smallest"],
    *,
    tape: Literal["contact", "taut"] = "contact",
    limb: bool = False,
) -> ExtremeGirth:
    """Search for the largest or smallest girth between two places.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or ndarray of shape (3,)
        The stretch.
    kind : {"largest", "smallest"}
    tape : {"contact", "taut"}
        Which of the two lengths is to be extreme.
    limb : bool
        Whether planes are perpendicular to the line from start to end, not horizontal.

    Returns
    -------
    ExtremeGirth

    Raises
    ------
    InputError
        As `plane_girth`, for any plane of the stretch, with the remedy to shorten it; or if the
        stretch is empty, or `kind` or `tape` is unknown.

    Notes
    -----
    17 planes at equal distances are tried first, and then Brent's method searches between the
    neighbors of the best one, unless that lies at an end, and the girth beside it is less extreme.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> waist = bm.extreme_girth(body, "bust point left", "front hip point", "smallest")
    >>> print(f"{waist.girth.contact:.4f} {body.unit} at {waist.height:.3f}, {waist.status.name}")
    0.6559 m at 1.037, INSIDE
    """
    for what, word, known in (
        ("kind", kind, ("largest", "smallest")),
        ("tape", tape, ("contact", "taut")),
    ):
        if str(word) not in known:
            raise InputError(f"{what} is {word!r}; expected {known[0]!r} or {known[1]!r}")
    stretch = _Stretch.between(atlas, start, end, limb=limb)
    sign = -1.0 if kind == "largest" else 1.0
    loops: dict[float, SectionLoop] = {}

    def cost(fraction: float) -> float:
        loop = loops[float(fraction)] = stretch.loop(float(fraction))
        return sign * (loop.length if tape == "contact" else convex_hull(loop).length)

    fractions = np.linspace(0.0, 1.0, SAMPLES)
    costs = np.array([cost(fraction) for fraction in fractions])
    best = int(np.argmin(costs))
    fraction = float(fractions[best])
    low, high = fractions[max(best - 1, 0)], fractions[min(best + 1, SAMPLES - 1)]
    # An extreme at an end of the stretch, where nothing beside it is more extreme, is found.
    beside = {0: 2.0 * TOLERANCE, SAMPLES - 1: 1.0 - 2.0 * TOLERANCE}.get(best)
    if beside is None or cost(beside) < costs[best]:
        found = scipy.optimize.minimize_scalar(
            cost, bounds=(low, high), method="bounded", options={"xatol": TOLERANCE}
        )
        # Brent's method stays away from the bounds, where the extreme may well be.
        fraction = float(found.x) if found.fun < costs[best] else fraction
    status = Extremum.INSIDE
    if fraction <= 2.0 * TOLERANCE:
        status = Extremum.AT_START
    elif fraction >= 1.0 - 2.0 * TOLERANCE:
        status = Extremum.AT_END
    height = float(stretch.point(fraction) @ atlas.axes.up_vector)
    return ExtremeGirth(girth_of_loop(loops[fraction]), fraction, height, status)


@dataclass(frozen=True, eq=False)
class _Stretch:
    """Parallel planes from one point to another."""

    atlas: Atlas
    first: Array
    last: Array
    normal: Array
    limb: bool

    @classmethod
    def between(cls, atlas: Atlas, start: Location, end: Location, *, limb: bool) -> "_Stretch":
        first = position_of(atlas, start, "the start")
        last = position_of(atlas, end, "the end")
        up = atlas.axes.up_vector
        if not limb and (last - first) @ up == 0.0:
            raise InputError(
                "the stretch starts and ends at one height, so there is nothing to search; "
                "expected two heights"
            )
        return cls(atlas, first, last, limb_axis(first, last) if limb else up, limb)

    def point(self, fraction: float) -> Array:
        return self.first + fraction * (self.last - self.first)

    def loop(self, fraction: float) -> SectionLoop:
        point = self.point(fraction)
        try:
            loop = section_loop(self.atlas, Plane(point, self.normal), point, limb=self.limb)
            if not loop.closed:
                raise InputError("the section is open: it ends on the boundary of the atlas")
        except InputError as error:
            raise InputError(
                f"at {100.0 * fraction:.1f} % of the stretch: {error}; or shorten the stretch"
            ) from None
        return loop
