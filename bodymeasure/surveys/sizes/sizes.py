"""A table of sizes: where each lies, whom it fits, and what its other measurements are."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.arguments import require_kind, require_members
from bodymeasure.errors import InputError
from bodymeasure.report.units import DEGREES, TAPE_DECIMALS
from bodymeasure.surveys.bodies.surveyed import unique_names
from bodymeasure.surveys.records import Column, SurveyTable
from bodymeasure.surveys.sizes.schemes import SizeScheme
from bodymeasure.threads import one_blas_thread

# By so many digits more than a tape has, the names of sizes may tell them apart.
MORE_DIGITS = 6


@dataclass(frozen=True)
class Control:
    """A measurement over the bodies that a size fits.

    Parameters
    ----------
    key : str
    bodies : int
        Those that have a value.
    mean, deviation : float or None
        None for too few.
    """

    key: str
    bodies: int
    mean: float | None
    deviation: float | None


@dataclass(frozen=True)
class Size:
    """A size.

    Parameters
    ----------
    name : str
        Its key measurements, with strokes between them.
    center : mapping of str to float
        The key measurements.
    bodies : int
        How many it fits.
    part, together : float
        The part of all bodies that this is, and that of this size and those that fit more.
    mannequin : int
        The body that is nearest to it, by its place in the survey.
    distance : float
        How far that one is from it, as root mean square of differences in steps.
    controls : tuple of Control
        All measurements of the survey, in its order.
    """

    name: str
    center: Mapping[str, float]
    bodies: int
    part: float
    together: float
    mannequin: int
    distance: float
    controls: tuple[Control, ...]


@dataclass(frozen=True, eq=False, repr=False)
class SizeTable:
    """The sizes of a population.

    Parameters
    ----------
    survey : SurveyTable
    keys : tuple of Column
        The key measurements.
    steps : mapping of str to float
        A size fits bodies within half a step to both sides, in each key measurement.
    sizes : tuple of Size
        In the order of their key measurements.
    bodies : int
        Bodies that have all key measurements, of which parts are parts.
    coverage : float
        The part of them that some size fits.
    """

    survey: SurveyTable
    keys: tuple[Column, ...]
    steps: Mapping[str, float]
    sizes: tuple[Size, ...]
    bodies: int
    coverage: float

    def __repr__(self) -> str:
        keys = ", ".join(column.key for column in self.keys)
        return f"<SizeTable of {len(self.sizes)} sizes by {keys}: {self.coverage:.1%} covered>"


@one_blas_thread()
def size_table(survey: SurveyTable, scheme: SizeScheme) -> SizeTable:
    """Return the sizes that a population needs, and whom each fits.

    Parameters
    ----------
    survey : SurveyTable
    scheme : SizeScheme
        `StepSizes`, sizes at multiples of steps, or `MedoidSizes`, so many where the bodies are.

    Returns
    -------
    SizeTable

    Raises
    ------
    InputError
        If the survey does not have the key measurements, or they are angles, no body has all of
        them, or no size fits enough bodies.
    MissingExtraError
        If kmedoids is not installed, and sizes are by medoids.

    Notes
    -----
    The idea is that of ISO 8559-3: key measurements with intervals make sizes, whose coverage of
    the population decides how many there are; the other measurements of a size are means over those
    that it fits.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> names = ["female_average", "female_full_bust", "female_heavy", "female_old"]
    >>> with TemporaryDirectory() as folder:
    ...     survey = bm.survey(names, folder=folder, only=["bust_girth", "hip_girth"])
    ...     table = bm.size_table(survey, bm.StepSizes({"bust_girth": 6.0}))
    ...     for size in table.sizes:
    ...         print(size.name, size.bodies, f"{size.part:.0%}", survey.subjects[size.mannequin])
    78 1 25% female_old
    84 1 25% female_average
    90 2 50% female_heavy
    """
    require_kind(survey, SurveyTable, "the survey", "what survey or read_survey returns")
    require_members(scheme, ("steps", "centers"), "the scheme", "StepSizes or MedoidSizes")
    keys = tuple(survey.column(key) for key in scheme.steps)
    for column in keys:
        if column.unit == DEGREES:
            raise InputError(f"{column.key} is an angle; expected lengths as key measurements")
    values = np.column_stack([survey[column.key] for column in keys])
    whole = np.flatnonzero(np.isfinite(values).all(axis=1))
    if not len(whole):
        listed = ", ".join(column.key for column in keys)
        raise InputError(f"no body of {survey.path} has all of {listed}; choose other keys")
    values = values[whole]
    centers = scheme.centers(values)
    if not len(centers):
        raise InputError(
            "no size fits enough bodies; take larger steps, or a smaller least part of the bodies"
        )
    step = np.array(list(scheme.steps.values()), dtype=np.float64)
    nearest, fits, distance = _fitted(values, centers, step)
    counts = np.bincount(nearest[fits], minlength=len(centers))
    controls = _controls(survey, whole, nearest, fits, len(centers))
    # The parts of the sizes that fit as many bodies or more, each size among them.
    order = np.argsort(-counts, kind="stable")
    together = np.empty(len(centers))
    together[order] = np.cumsum(counts[order]) / len(values)
    names, sizes = _names(centers, keys), []
    for number, center in enumerate(centers):
        near = int(np.argmin(np.where(nearest == number, distance, np.inf)))
        sizes.append(
            Size(
                name=names[number],
                center=dict(zip(scheme.steps, map(float, center), strict=True)),
                bodies=int(counts[number]),
                part=float(counts[number] / len(values)),
                together=float(together[number]),
                mannequin=int(whole[near]),
                distance=float(distance[near]),
                controls=controls[number],
            )
        )
    covered = float(fits.mean())
    return SizeTable(survey, keys, dict(scheme.steps), tuple(sizes), len(values), covered)


def _fitted(values: Array, centers: Array, step: Array) -> tuple[Ints, Array, Array]:
    """Return the size that each body is nearest to, whether that fits it, and how far it is."""
    best = np.full(len(values), np.inf)
    nearest = np.zeros(len(values), dtype=np.int64)
    fits = np.zeros(len(values), dtype=bool)
    for number, center in enumerate(centers):
        apart = (values - center) / step
        distance = np.sqrt(np.mean(apart**2, axis=1))
        # Half a step below belongs to a size, half a step above to the next.
        inside = ((apart >= -0.5) & (apart < 0.5)).all(axis=1)
        # One that fits goes before one that is nearer, but fits not.
        better = (inside & ~fits) | ((inside == fits) & (distance < best))
        best[better], nearest[better], fits[better] = distance[better], number, inside[better]
    return nearest, fits, best


def _controls(
    survey: SurveyTable, whole: Ints, nearest: Ints, fits: Array, count: int
) -> list[tuple[Control, ...]]:
    found: list[list[Control]] = [[] for _ in range(count)]
    for column in survey.measurements:
        values = survey[column.key][whole]
        for number in range(count):
            known = values[fits & (nearest == number) & np.isfinite(values)]
            found[number].append(
                Control(
                    column.key,
                    len(known),
                    float(known.mean()) if len(known) else None,
                    float(known.std(ddof=1)) if len(known) > 1 else None,
                )
            )
    return [tuple(each) for each in found]


def _names(centers: Array, keys: tuple[Column, ...]) -> list[str]:
    """Return the names of sizes, with as many digits as tell all of them apart.

    Files are named after them, too.
    """
    for more in range(MORE_DIGITS + 1):
        names = [
            "/".join(_digits(*each, more) for each in zip(one, keys, strict=True))
            for one in centers
        ]
        if len(set(names)) == len(names):
            return names
    return list(unique_names(names))


def _digits(value: float, column: Column, more: int) -> str:
    """Return a key measurement as the name of a size has it."""
    return f"{value:.{TAPE_DECIMALS[column.unit] + more}f}".removesuffix(".0")
