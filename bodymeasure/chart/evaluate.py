"""The measurement of a body by a set of definitions."""

import time
from collections.abc import Callable, Mapping
from dataclasses import replace

from bodymeasure.atlas import Atlas, Severity
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.atlas.check.stance import stance_findings
from bodymeasure.chart.body import Body, MissingLandmarkError
from bodymeasure.chart.chart import Chart
from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.landmarks.derive import derive_landmarks
from bodymeasure.chart.reading.read import load_definitions
from bodymeasure.chart.sides import both_sides
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.measure import package_versions
from bodymeasure.threads import one_blas_thread

# Packages whose versions can change a number of a chart.
PACKAGES = ("bodymeasure", "numpy", "scipy", "pygeodesic")


@one_blas_thread()
def measure_chart(
    atlas: Atlas,
    definitions: Definitions | None = None,
    *,
    progress: Callable[[int, int], None] | None = None,
    despite_errors: bool = False,
) -> Chart:
    """Measure a body by a set of definitions.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions, optional
        The default set if not given; `load_definitions` reads others.
    progress : callable, optional
        Called with the number of measurements done so far, and the number of all.
    despite_errors : bool
        Whether to measure a body whose landmarks contradict its axes, sides or size.

    Returns
    -------
    Chart
        A measurement that cannot be taken gives the reason; the others are taken all the same.

    Raises
    ------
    InputError
        If the landmarks contradict the axes, the sides or the size (`check_atlas` says how), unless
        `despite_errors` is true; if rules for landmarks need one another in a circle; or if two
        measurements have one key.
    MissingExtraError
        If paths are asked for and pygeodesic is not installed.

    Notes
    -----
    Heights are measured from the floor, where the coordinate along the atlas's way up is 0.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from msgspec.structs import replace
    >>> every = bm.load_definitions()
    >>> girths = tuple(each for each in every.measurement if each.key == "waist_girth")
    >>> few = replace(every, measurement=girths, landmark=())
    >>> chart = bm.measure_chart(bm.load_sample("female_average"), few)
    >>> waist = chart["waist_girth"]
    >>> print(f"{waist.value:.4f} {chart.atlas.unit}, {waist.outcome}")
    0.7110 m, measured
    """
    begin = time.perf_counter()
    require_atlas(atlas)
    if not despite_errors:
        _require_sound_landmarks(atlas)
    definitions = load_definitions() if definitions is None else definitions
    derived = derive_landmarks(atlas, definitions.landmark, strict=False)
    body = Body(atlas, derived.landmarks, derived.missing)
    every: dict[str, MeasurementDefinition] = {}
    for one in both_sides(definitions.measurement):
        if one.key in every:
            raise InputError(f"two measurements have the key {one.key!r}; rename or remove one")
        every[one.key] = one
    taken = _Taken(body, every)
    measured = []
    for number, key in enumerate(every, start=1):
        measured.append(taken[key])
        if progress is not None:
            progress(number, len(every))
    return Chart(
        atlas,
        definitions,
        body.landmarks,
        body.missing,
        tuple(measured),
        time.perf_counter() - begin,
        package_versions(PACKAGES),
    )


def _require_sound_landmarks(atlas: Atlas) -> None:
    faults = [
        f"{finding.kind}: {finding.message}"
        for finding in stance_findings(atlas)
        if finding.severity == Severity.ERROR
    ]
    if faults:
        listed = "".join(f"\n  {fault}" for fault in faults)
        raise InputError(
            f"{atlas.name or 'the atlas'}: the landmarks contradict the axes, the sides or the "
            f"size:{listed}\nRepair it, or measure with despite_errors=True"
        )


class _Taken(dict[str, Measured]):
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
        try:
            if fault := next(definition.faults(), None):
                raise InputError(fault.words)
            found = definition.measure(self.body, self)
        except MissingLandmarkError as error:
            found = Measured(definition, Outcome.MISSING_LANDMARK, str(error))
        except InputError as error:
            found = Measured(definition, Outcome.REFUSED, str(error))
        except ConvergenceError as error:
            found = Measured(definition, Outcome.NOT_CONVERGED, str(error))
        unit = "deg" if definition.in_degrees else self.body.atlas.unit.value
        self[key] = replace(found, unit=unit)
        return self[key]
