"""A body that was made to measure."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.chart import Definitions
from bodymeasure.chart.sides import both_sides
from bodymeasure.make.body.measuring import Measuring, can_be_asked
from bodymeasure.make.body.prior import Prior
from bodymeasure.make.input.measurements import Value
from bodymeasure.report.units import DEGREES
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import counted


@dataclass(frozen=True)
class Asked:
    """A measurement that was asked for, and what the body has.

    Parameters
    ----------
    value : Value
        As it was asked for.
    found : float
        What the body has, in the same unit; NaN if it cannot be measured there.
    deviation : float
        The standard deviation of the value over all bodies that have the measurements asked for, in
        the same unit: next to nothing unless measurements contradict each other.
    reason : str
        Why it cannot be measured.
    """

    value: Value
    found: float
    deviation: float
    reason: str = ""

    @property
    def miss(self) -> float:
        """What the body has more than was asked for, in the same unit."""
        return self.found - self.value.value


@dataclass(frozen=True)
class Predicted:
    """A measurement of the chart, and how sure it is.

    Parameters
    ----------
    key, name : str
    value : float
        In meters or degrees.
    deviation : float
        Its standard deviation over all bodies that have the measurements asked for.
    unit : str
        m or deg.
    asked : bool
        Whether it was asked for.
    """

    key: str
    name: str
    value: float
    deviation: float
    unit: str
    asked: bool


@dataclass(frozen=True, eq=False, repr=False)
class MadeBody:
    """The most plausible body with some measurements, as `make_body` returns it.

    Parameters
    ----------
    atlas : Atlas
        In meters, in the A-pose, with landmarks and with the lengths of head, hands and feet.
    vertices : ndarray, shape (13380, 3)
        Control vertices of the quad mesh, whose Catmull-Clark limit the atlas approximates.
    coefficients : ndarray, shape (120,)
        In the space of bodies, in standard deviations.
    asked : tuple of Asked
    rounds : int
    chi_square, probability : float
        How far the measurements are from those of the mean body, and the part of all bodies that
        are as far out.
    warnings : tuple of str
    notes : tuple of str
        What the source of the measurements holds besides.
    prior : Prior
    covariance : ndarray, shape (120, 120)
        Of the coefficients, over all bodies that have the measurements asked for.
    definitions : Definitions
    """

    atlas: Atlas
    vertices: Array
    coefficients: Array
    asked: tuple[Asked, ...]
    rounds: int
    chi_square: float
    probability: float
    warnings: tuple[str, ...]
    notes: tuple[str, ...]
    prior: Prior
    covariance: Array
    definitions: Definitions

    @property
    def largest_miss(self) -> float:
        """The largest miss of a length, in meters."""
        misses = [
            abs(one.miss) / one.value.factor for one in self.asked if one.value.unit != DEGREES
        ]
        return max(misses, default=0.0)

    def __repr__(self) -> str:
        count = counted(len(self.asked), "measurement")
        return (
            f"<MadeBody {self.atlas.name!r}: {count}, missed by at most "
            f"{1e3 * self.largest_miss:.2g} mm>"
        )

    @one_blas_thread()
    def predicted(self, only: Sequence[str] = ()) -> tuple[Predicted, ...]:
        """Measure the body, and say how sure each value is: what was asked for, and all else.

        Parameters
        ----------
        only : sequence of str
            Keys of measurements, with their sides; all of the set that the bodies have if not
            given.

        Returns
        -------
        tuple of Predicted

        Raises
        ------
        InputError
            If a measurement is not in the set, or bodies cannot be asked for it.

        Notes
        -----
        The standard deviation is ``sqrt(g' C g)`` with the value's derivative g by the coefficients
        and their covariance C. The spread of the space is that of an artist's morphs, and not of a
        population.

        Examples
        --------
        >>> import bodymeasure as bm
        >>> body = bm.make_body({"stature": 168, "waist_girth": 72, "hip_girth": 98}, unit="cm")
        >>> waist, bust = body.predicted(["waist_girth", "bust_girth"])
        >>> waist.deviation < 0.001 < 0.01 < bust.deviation
        True
        """
        every = {one.key: one for one in both_sides(self.definitions.measurement)}
        keys = list(only) or [key for key in every if can_be_asked(self.definitions, key)]
        readout = Measuring(self.definitions, keys).of(self.coefficients)
        variance = np.einsum("ki,ij,kj->k", readout.slopes, self.covariance, readout.slopes)
        asked = {one.value.key for one in self.asked}
        return tuple(
            Predicted(
                key,
                every[key].name,
                float(value),
                float(np.sqrt(max(spread, 0.0))),
                DEGREES if every[key].in_degrees else "m",
                key in asked,
            )
            for key, value, spread in zip(keys, readout.values, variance, strict=True)
        )
