"""Paths along the surface through landmarks."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import ClassVar

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, length_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.input.slopes import tape_slopes
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome, TapeWanted
from bodymeasure.chart.kinds.surface.along import along
from bodymeasure.chart.landmarks.paths import leg_between
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.taut import taut_tape


class PathMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="path"):
    """The shortest path along the surface through landmarks.

    Parameters
    ----------
    through : tuple of str
        The landmarks, in order.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = 'through = ["front waist point", "crotch point", "back waist point"]'

    through: tuple[Landmark, ...]
    tape: TapeWanted = "contact"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return length_class(self.name)

    def faults(self) -> Iterator[Fault]:
        if len(self.through) < 2:
            yield Fault(self, "through", "through needs two landmarks or more")
        for one, other in pairwise(self.through):
            yield from self.same_place("through", one, other)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        points = [body.point(name) for name in self.through]
        path = AtlasPath.concatenate([leg_between(body.atlas, *ends) for ends in pairwise(points)])
        contact = along(body, self, path)
        if self.tape == "contact" or contact.outcome is not Outcome.MEASURED:
            return contact
        taut = self._drawn_taut(path, contact)
        if taut.outcome is not Outcome.MEASURED and self.tape == "both":
            # The length asked for is there; the one beside it is not.
            return replace(contact, reason=f"There is no taut length: {taut.reason}")
        return taut

    def _drawn_taut(self, path: AtlasPath, contact: Measured) -> Measured:
        """Return the measurement with its tape drawn taut, as far as that can be done."""
        start, *via, end = path.points
        try:
            tape = taut_tape(path.atlas, start, end, via, contact=path, on_failure="status")
        except InputError as error:
            return Measured(self, Outcome.REFUSED, str(error))
        status = tape.status
        if not tape.converged:
            return Measured(
                self,
                Outcome.NOT_CONVERGED,
                status.sentence,
                status.name,
                landmarks=contact.landmarks,
            )
        return replace(
            contact,
            status=status.name,
            value=tape.length if self.tape == "taut" else path.length,
            taut=tape.length,
            error_estimate=max(path.error_estimate, tape.error_estimate),
            tapes=(*contact.tapes, Tape(TapeKind.TAUT, tape.points, tape.normals)),
        )

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        return tape_slopes(found.tape, {name: body.position(name) for name in self.through})
