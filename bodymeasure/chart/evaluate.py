"""The measurement of a body by a set of definitions."""

import time
from collections.abc import Callable, Iterable, Sequence

from bodymeasure.arguments import require_kind, require_progress, several
from bodymeasure.atlas import Atlas, Severity
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.atlas.check.stance import stance_findings
from bodymeasure.chart.body import Body
from bodymeasure.chart.chart import Chart
from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.input.landmarks import landmark_trust
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.landmarks.derive import derive_landmarks
from bodymeasure.chart.reading.read import load_definitions
from bodymeasure.chart.selection import restricted, selected_keys
from bodymeasure.chart.sensitivity import with_shifts
from bodymeasure.chart.sides import both_sides
from bodymeasure.chart.taken import Taken
from bodymeasure.errors import InputError
from bodymeasure.measure import package_versions
from bodymeasure.threads import one_blas_thread


@one_blas_thread()
def measure_chart(
    atlas: Atlas,
    definitions: Definitions | None = None,
    *,
    only: Sequence[str] = (),
    sensitivity: bool = False,
    progress: Callable[[int, int], None] | None = None,
    despite_errors: bool = False,
) -> Chart:
    """Measure a body by a set of definitions.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions, optional
        The default set if not given; `load_definitions` reads others.
    only : sequence of str
        The measurements to take, all if none are given: keys, keys without ``_left`` or
        ``_right``, which stand for both, and names of the set's presets, such as ``core``.
    sensitivity : bool
        Whether to say by how much each value changes if one of its landmarks lies 5 mm higher, or
        5 mm to the side. Each takes as long as the measurement itself.
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
        `despite_errors` is true; if `only` names what the set does not have; if rules for landmarks
        need one another in a circle; or if two measurements have one key.

    Notes
    -----
    Heights are measured from the floor, where the coordinate along the atlas's way up is 0.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> chart = bm.measure_chart(bm.load_sample("female_average"), only=["waist_girth"])
    >>> waist = chart["waist_girth"]
    >>> print(f"{waist.value:.4f} {chart.atlas.unit}, {waist.outcome}")
    0.7110 m, measured
    """
    begin = time.perf_counter()
    require_atlas(atlas)
    if not despite_errors:
        _require_sound_landmarks(atlas)
    definitions = load_definitions() if definitions is None else definitions
    require_kind(definitions, Definitions, "definitions", "what load_definitions returns")
    require_progress(progress)
    chosen, needed = restricted(definitions, names_listed(only))
    derived = derive_landmarks(atlas, needed.landmark, strict=False)
    body = Body(atlas, derived.landmarks, derived.missing, landmark_trust(atlas, derived))
    taken = Taken(body, _by_key(needed.measurement))
    keys = [one.key for one in both_sides(chosen.measurement)]
    named = selected_keys(definitions, [name for name in only if name not in definitions.presets])
    measured, elsewhere = [], dict[str, tuple[Taken, Taken]]()
    for number, key in enumerate(keys, start=1):
        measured.append(with_shifts(taken, key, elsewhere) if sensitivity else taken[key])
        if progress is not None:
            progress(number, len(keys))
    return Chart(
        atlas,
        needed,
        body.landmarks,
        body.missing,
        tuple(item for item in measured if item.definition.key in named or not _left_out(item)),
        time.perf_counter() - begin,
        package_versions(),
        body.trust.uncertainty,
        tuple(only),
    )


def names_listed(only: Sequence[str]) -> Sequence[str]:
    """Return names, once it is known that they are several.

    Raises
    ------
    InputError
        If they are a single name.
    """
    if isinstance(only, str):
        raise InputError(f"only is {only!r}; expected a list of names, such as [{only!r}]")
    return several(only, str, "only", "the key of a measurement")


def _by_key(definitions: Iterable[MeasurementDefinition]) -> dict[str, MeasurementDefinition]:
    every: dict[str, MeasurementDefinition] = {}
    for one in both_sides(definitions):
        if one.key in every:
            raise InputError(f"two measurements have the key {one.key!r}; rename or remove one")
        every[one.key] = one
    return every


def _left_out(item: Measured) -> bool:
    """Return whether the chart of a body without some landmarks does without a measurement."""
    lacking = (Outcome.MISSING_LANDMARK, Outcome.MISSING_OPERAND)
    return item.definition.optional and item.outcome in lacking


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
