"""The measurements of a body of the space, with their derivatives by its coefficients."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, GivenLength
from bodymeasure.chart import Definitions, derive_landmarks
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.selection import restricted
from bodymeasure.chart.sides import both_sides
from bodymeasure.chart.taken import Taken
from bodymeasure.errors import InputError
from bodymeasure.extremities.measure import ORIGIN
from bodymeasure.make.body.atlases import atlas_of, point_components
from bodymeasure.make.body.stature import stature_of
from bodymeasure.make.gradient import gradient_of, has_gradient

STATURE = "stature"
WHOLE = "head, hands and feet follow from the rest of the body, but for the stature; leave it out"


@dataclass(frozen=True, eq=False)
class Readout:
    """Measurements of a body and their derivatives.

    Parameters
    ----------
    values : ndarray, shape (k,)
        In meters and degrees; NaN where a measurement cannot be taken on the body.
    slopes : ndarray, shape (k, 120)
        The derivative by each coefficient.
    reasons : tuple of str
        Why there is no value.
    """

    values: Array
    slopes: Array
    reasons: tuple[str, ...]


class Measuring:
    """Some measurements, to be taken on one body after another.

    Parameters
    ----------
    definitions : Definitions
    keys : sequence of str
        With left or right in place of ``{side}``.

    Raises
    ------
    InputError
        If one of them cannot be made to measure.
    """

    def __init__(self, definitions: Definitions, keys: Sequence[str]) -> None:
        _, self._needed = restricted(definitions, list(keys))
        self._by_key = {one.key: one for one in both_sides(self._needed.measurement)}
        self._rules = {rule.name for rule in both_sides(self._needed.landmark)}
        self.keys = tuple(keys)
        for key in keys:
            if reason := self._fault(key):
                raise InputError(f"{key!r} cannot be asked of a body: {reason}")

    @property
    def by_key(self) -> dict[str, MeasurementDefinition]:
        """The measurements, and those that their formulas name."""
        return self._by_key

    def _fault(self, key: str) -> str:
        """Return why a measurement cannot be made to measure; empty if it can."""
        definition = self._by_key[key]
        if key == STATURE:
            return ""
        for operand in definition.operands:
            if reason := self._fault(operand):
                return f"it needs {operand!r}, and {reason}"
        if not has_gradient(definition):
            return f"it is of the kind {type(definition).tag()!r}; {WHOLE}"
        own = atlas_of(np.zeros(120)).landmarks
        absent = [n for n in definition.landmarks if n not in own and n not in self._rules]
        if absent:
            return f"the bodies have no landmark {absent[0]!r}; {WHOLE}"
        return ""

    def of(self, coefficients: Array, *, slopes: bool = True) -> Readout:
        """Return the measurements of a body.

        Parameters
        ----------
        coefficients : ndarray, shape (120,)
        slopes : bool
            Whether their derivatives are wanted, too; else they are 0.
        """
        atlas, rise = self._atlas(coefficients)
        derived = derive_landmarks(atlas, self._needed.landmark, strict=False)
        body = Body(atlas, derived.landmarks, derived.missing)
        taken = Taken(body, self._by_key)
        found = [taken[key] for key in self.keys]
        rows = np.zeros((len(found), len(coefficients)))
        flat = point_components().reshape(len(coefficients), -1)
        for row, item in enumerate(found):
            if not slopes or item.outcome is not Outcome.MEASURED:
                continue
            pull = gradient_of(item.definition.key, taken, body, derived)
            rows[row] = flat @ pull.weights.ravel()
            for share in pull.given.values():
                rows[row] += share * rise
        values = np.array([item.value for item in found])
        return Readout(values, rows, tuple(_reason(item) for item in found))

    def _atlas(self, coefficients: Array) -> tuple[Atlas, Array]:
        atlas = atlas_of(coefficients)
        if STATURE not in self._by_key:
            return atlas, np.zeros(len(coefficients))
        stature, rise = stature_of(coefficients)
        return replace(atlas, given={STATURE: GivenLength(stature, origin=ORIGIN)}), rise


def _reason(item: Measured) -> str:
    return "" if item.outcome is Outcome.MEASURED else item.reason or item.outcome.value


def can_be_asked(definitions: Definitions, key: str) -> bool:
    """Return whether bodies of the space can be asked for a measurement."""
    try:
        Measuring(definitions, [key])
    except InputError:
        return False
    return True
