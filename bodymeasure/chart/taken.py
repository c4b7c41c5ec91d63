"""The measurements of one body, each taken when it is first asked for."""

from collections.abc import Mapping
from dataclasses import replace

from bodymeasure.chart.approximated import approximated
from bodymeasure.chart.body import Body, MissingLandmarkError
from bodymeasure.chart.input.uncertainty import with_input
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.kinds.formula import FormulaMeasure
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic import Status
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.trust import LARGEST_ERROR, is_known


class Taken(dict[str, Measured]):
    """The measurements of a body by key; each is taken when it is first asked for.

    A formula asks for its operands, which so are taken before it.
    """

    def __init__(self, body: Body, definitions: Mapping[str, MeasurementDefinition]) -> None:
        super().__init__()
        self.body, self.definitions = body, definitions
        self._begun: set[str] = set()

    def __missing__(self, key: str) -> Measured:
        # Files are checked when they are read; definitions made in Python may be wrong.
        if key not in self.definitions:
            raise InputError(f"no measurement has the key {key!r}; name measurements by their keys")
        if key in self._begun:
            raise InputError(f"{key!r} is needed to compute itself; define it by landmarks")
        self._begun.add(key)
        definition = self.definitions[key]
        given = None
        try:
            if fault := next(definition.faults(), None):
                raise InputError(fault.words)
            found = self._if_known(definition.measure(self.body, self))
        except MissingLandmarkError as error:
            given = self._given(definition)
            found = given or Measured(definition, Outcome.MISSING_LANDMARK, str(error))
        except InputError as error:
            found = Measured(definition, Outcome.REFUSED, str(error))
        except ConvergenceError as error:
            found = Measured(definition, Outcome.NOT_CONVERGED, str(error))
        unit = "deg" if definition.in_degrees else self.body.atlas.unit.value
        if given is None:
            found = with_input(approximated(found, self.body.atlas), self.body, self)
        self[key] = replace(found, unit=unit)
        return self[key]

    def _given(self, definition: MeasurementDefinition) -> Measured | None:
        """Return what the body gives in place of a measurement whose landmarks it lacks."""
        length = self.body.atlas.given.get(definition.key)
        if length is None or definition.in_degrees:
            return None
        return Measured(
            definition,
            Outcome.MEASURED,
            length.origin,
            value=length.value,
            error_estimate=length.error_estimate,
            input_uncertainty=length.uncertainty or None,
            surface_uncertainty=length.uncertainty,
        )

    def _if_known(self, found: Measured) -> Measured:
        """Return a measurement, without its value if that is not known well enough.

        An angle has no length, and a formula is as good as its operands, which have been checked.
        """
        definition, error = found.definition, found.error_estimate
        computed = definition.in_degrees or isinstance(definition, FormulaMeasure)
        size = extent(self.body.atlas)
        if computed or found.outcome is not Outcome.MEASURED or is_known(found.value, error, size):
            return found
        unit = self.body.atlas.unit.value
        return Measured(
            definition,
            Outcome.NOT_CONVERGED,
            f"The length that was found, {found.value:.4g} {unit}, is known to {error:.1g} {unit} "
            f"only, which is more than {LARGEST_ERROR:g} of it; look near it with `bodymeasure "
            "check` for folds and cusps.",
            Status.INACCURATE.name,
            landmarks=found.landmarks,
        )
