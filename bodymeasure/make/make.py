"""Bodies made to measure."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import require_kind, require_progress, shown
from bodymeasure.atlas import Unit
from bodymeasure.chart import Definitions, load_definitions
from bodymeasure.errors import InputError
from bodymeasure.extremities import extremity_lengths
from bodymeasure.fit.model import body_model, shaped
from bodymeasure.make.body.atlases import COUNT, atlas_of
from bodymeasure.make.body.measuring import Measuring
from bodymeasure.make.body.prior import Prior, prior_of
from bodymeasure.make.checks.plausible import plausibility_of
from bodymeasure.make.checks.told import told
from bodymeasure.make.input.json_files import value_of
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.result import Asked, MadeBody
from bodymeasure.make.solve import Solution, Wanted, solved
from bodymeasure.report.units import DEGREES
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import counted

# In millimeters: values are met to a small part of this unless they contradict each other.
TOLERANCE = 0.1
# Degrees that stand for a millimeter of tolerance: some 15 cm away, it is 0.4 degrees.
DEGREES_FOR_MM = 0.2
# With fewer, nearly any body would do; with more, tapes say again what others have said, a little
# differently, and no body of the space meets them all.
FEWEST, MOST = 3, 40
# Rounds after which a set is given up: 3 are usual.
MOST_ROUNDS = 15
# In millimeters: a miss worth a warning is larger than what a tape can tell.
MISSED = 1.0
# In tolerances: the same, where the tolerance is wide.
LOOSE = 3.0
# In standard deviations: bodies of the space have no larger coefficients.
FAR = 4.5


@one_blas_thread()
def make_body(
    values: Mapping[str, float | str] | Measurements,
    *,
    unit: Unit | str | None = None,
    sex: str | None = None,
    age: float | None = None,
    definitions: Definitions | None = None,
    tolerance: float = TOLERANCE,
    components: int = COUNT,
    name: str | None = None,
    despite_doubts: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> MadeBody:
    """Make the most plausible body that has some measurements.

    Parameters
    ----------
    values : mapping of str to float or str, or Measurements
        Three to forty measurements by their keys or names, such as ``{"waist_girth": 72}``, or with
        units of their own, such as ``{"waist_girth": "28 1/4 in"}``; or what `read_measurements`
        returns. A key without its ``_left`` or ``_right`` is of the right side.
    unit : Unit or str, optional
        Unit of the lengths that are numbers; never guessed. Angles are in degrees.
    sex : {"female", "male"}, optional
        What the source says, if not given.
    age : float, optional
        In years, from 18 to 90.
    definitions : Definitions, optional
        The set that the measurements belong to; the default set if not given.
    tolerance : float
        The standard deviation in millimeters with which the values are to be met.
    components : int
        How many components of the space of bodies are used, from 10 to 120.
    name : str, optional
        Of the body; that of the source if not given.
    despite_doubts : bool
        Whether a set that no body is likely to have is met as well as can be.
    progress : callable, optional
        Called with the number of rounds done so far, and the most there may be.

    Returns
    -------
    MadeBody

    Raises
    ------
    InputError
        If a measurement is unknown, cannot be asked for or has no unit; if they are too few; or if
        no body is likely to have them, where the message says which is at fault and what would be
        plausible.

    Notes
    -----
    Bodies are points of a space with 120 coefficients b, whose prior is normal with variance 1. The
    body has the least ``|b - mean|^2 + sum ((m(b) - t) / tolerance)^2``. Derivatives of girths and
    geodesics take no differences, since a shortest path changes to first order only with the skin
    below it. Sex and age move the mean along the differences of three sample bodies.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.make_body({"stature": 168, "waist_girth": 72, "hip_girth": 98}, unit="cm")
    >>> body.asked[1].value.key, round(body.asked[1].found, 2)
    ('waist_girth', 72.0)
    >>> round(bm.body_girth(body.atlas, "front waist point").taut, 3)
    0.72
    """
    require_progress(progress)
    definitions = load_definitions() if definitions is None else definitions
    require_kind(definitions, Definitions, "definitions", "what load_definitions returns")
    wanted = measurements_from(values, definitions, unit)
    check_settings(tolerance, components)
    prior = prior_of(wanted.sex if sex is None else sex, age)
    measuring = Measuring(definitions, [value.key for value in wanted.values])
    return made(
        wanted,
        measuring,
        prior,
        definitions=definitions,
        tolerance=tolerance,
        components=components,
        name=wanted.name if name is None else name,
        despite_doubts=despite_doubts,
        report=None if progress is None else lambda done: progress(done, MOST_ROUNDS),
    )


def measurements_from(
    values: Mapping[str, float | str] | Measurements,
    definitions: Definitions,
    unit: Unit | str | None,
) -> Measurements:
    """Return measurements that were given in Python, once they are known to be enough.

    Raises
    ------
    InputError
        If they are not what `make_body` takes.
    """
    if isinstance(values, Measurements):
        found = values
    elif isinstance(values, Mapping):
        names, own = Names(definitions), None if unit is None else Unit.parse(unit).value
        by_key: dict[str, Value] = {}
        for text, value in values.items():
            require_kind(text, str, "a measurement", "its key, a str")
            key = names.find(text, "values")
            if key in by_key:
                raise InputError(f"values: {key!r} is given a second time, as {text!r}; keep one")
            by_key[key] = value_of(key, _plain(value), own, f"values: {text}", names)
        found = Measurements("", tuple(by_key.values()))
    else:
        raise InputError(
            f"values is {values!r}; expected a mapping of keys to values, or what "
            "read_measurements returns for one body"
        )
    count = len(found.values)
    if not FEWEST <= count <= MOST:
        what = counted(count, "measurement")
        raise InputError(
            f"{found.name or 'values'}: has {what}; expected {FEWEST} to {MOST}: "
            + (
                "with fewer, nearly any body would do"
                if count < FEWEST
                else "choose some, with --only or read_measurements(..., only=['core'])"
            )
        )
    return found


def _plain(value: object) -> object:
    """Return numbers of NumPy as Python's."""
    return value.item() if isinstance(value, np.generic) else value


def check_settings(tolerance: float, components: int) -> None:
    """Refuse settings that `make_body` cannot take."""
    if not isinstance(tolerance, (int, float, np.number)) or not 0.001 <= tolerance <= 50.0:
        raise InputError(f"tolerance is {shown(tolerance)}; expected 0.001 to 50 mm")
    if not isinstance(components, (int, np.integer)) or not 10 <= components <= COUNT:
        raise InputError(f"components is {shown(components)}; expected 10 to {COUNT}")


def made(
    measurements: Measurements,
    measuring: Measuring,
    prior: Prior,
    *,
    definitions: Definitions,
    tolerance: float,
    components: int,
    name: str,
    despite_doubts: bool,
    report: Callable[[int], None] | None = None,
) -> MadeBody:
    """Make a body; the arguments are those of `make_body`, checked."""
    values = measurements.values
    degrees = np.array([value.unit == DEGREES for value in values])
    first = measuring.of(prior.mean)
    said = told(first, values)
    if said.refusal and not despite_doubts:
        whose = f"{measurements.name}: " if measurements.name else ""
        raise InputError(f"{whose}{said.refusal}")
    wanted = Wanted(
        np.array([value.base for value in values]),
        np.where(degrees, DEGREES_FOR_MM * tolerance, 1e-3 * tolerance),
        degrees,
    )
    solution = solved(
        measuring,
        wanted,
        prior,
        first=first,
        components=components,
        most_rounds=MOST_ROUNDS,
        report=report,
    )
    covariance = _covariance(solution, wanted)
    asked = _asked(values, solution, covariance)
    warnings = (said.refusal,) if said.refusal else said.warnings
    vertices = shaped(solution.coefficients)
    atlas = atlas_of(solution.coefficients, name=name, provenance=_provenance(prior, values))
    return MadeBody(
        atlas=replace(atlas, given=extremity_lengths(vertices, body_model().quads)),
        vertices=vertices,
        coefficients=solution.coefficients,
        asked=asked,
        rounds=solution.rounds,
        chi_square=said.judgment.chi_square,
        probability=said.judgment.probability,
        warnings=(*warnings, *_after(solution, wanted, values, prior)),
        notes=measurements.notes,
        prior=prior,
        covariance=covariance,
        definitions=definitions,
    )


def _covariance(solution: Solution, wanted: Wanted) -> Array:
    """Return the covariance of the coefficients over the bodies that have the measurements."""
    slopes = solution.readout.slopes / wanted.tolerance[:, None]
    return np.asarray(np.linalg.inv(np.eye(slopes.shape[1]) + slopes.T @ slopes))


def _asked(values: tuple[Value, ...], solution: Solution, covariance: Array) -> tuple[Asked, ...]:
    slopes = solution.readout.slopes
    deviation = np.sqrt(np.einsum("ki,ij,kj->k", slopes, covariance, slopes).clip(0.0))
    found = []
    for row, value in enumerate(values):
        scale = value.factor
        reason = solution.readout.reasons[row]
        there = float(solution.readout.values[row]) * scale if not reason else float("nan")
        found.append(Asked(value, there, float(deviation[row]) * scale, reason))
    return tuple(found)


def _after(
    solution: Solution, wanted: Wanted, values: tuple[Value, ...], prior: Prior
) -> tuple[str, ...]:
    """Return what there is to look at once a body was found."""
    words = []
    miss = np.abs(solution.readout.values - wanted.values)
    limit = np.where(wanted.degrees, DEGREES_FOR_MM * MISSED, 1e-3 * MISSED)
    # What was to be met less closely may be missed by more.
    limit = np.maximum(limit, LOOSE * wanted.tolerance)
    for row in np.argsort(-miss / limit).tolist():
        if miss[row] > limit[row]:
            value = values[row]
            words.append(
                f"{value.key} is missed by {value.written(float(miss[row]), 2)}: no body near has "
                "all of these measurements; they may contradict each other by so much"
            )
    for row, reason in enumerate(solution.readout.reasons):
        if reason:
            words.append(f"{values[row].key} cannot be measured on the body: {reason}")
    if not solution.settled:
        words.append(
            f"after {counted(solution.rounds, 'round')} the body still changes; look at the misses"
        )
    largest, _ = plausibility_of(solution.coefficients, prior)
    if largest > FAR:
        words.append(
            f"the body is {largest:.1f} standard deviations from the mean in one way; look at it"
        )
    return tuple(words)


def _provenance(prior: Prior, values: tuple[Value, ...]) -> dict[str, str]:
    known = [f"sex {prior.sex}"] if prior.sex else []
    known += [f"age {prior.age:g}"] if prior.age is not None else []
    return {
        "source": f"made from {counted(len(values), 'measurement')}"
        + (f", {', '.join(known)}" if known else ""),
        "method": "bodymeasure make: the most plausible body of a space that has the measurements",
        "measurements": ", ".join(f"{value.key} {value.value:g} {value.unit}" for value in values),
    }
