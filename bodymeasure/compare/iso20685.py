"""What the differences of a measurement come to, and the verdict of ISO 20685-1 on their mean."""

import math
from collections.abc import Sequence
from statistics import fmean, stdev

import numpy as np
from scipy.special import stdtrit

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.chart import AccuracyClass
from bodymeasure.compare.intraclass import intraclass
from bodymeasure.compare.limits import limits_of_agreement
from bodymeasure.compare.records import Agreement, ClassVerdict, Difference, Verdict

# The least number of test subjects that the standard asks for.
MINIMUM_SUBJECTS = 40
CONFIDENCE = 0.95


def confidence_interval(differences: Sequence[float]) -> tuple[float, float] | None:
    """Return the 95 % confidence interval of the mean by Student's t; None for fewer than two.

    Parameters
    ----------
    differences : sequence of float
        One for each subject, at least two.
    """
    count = len(differences)
    if count < 2:
        return None
    t = float(stdtrit(count - 1, 0.5 + 0.5 * CONFIDENCE))
    mean, half = fmean(differences), t * stdev(differences) / math.sqrt(count)
    return mean - half, mean + half


def agreement(differences: Sequence[Difference], minimum_subjects: int) -> Agreement:
    """Return the differences of one measurement over at least one subject, taken together."""
    first = differences[0]
    values = [each.difference for each in differences]
    interval = confidence_interval(values)
    largest = max(differences, key=lambda each: abs(each.difference))
    limits = limits_of_agreement(values)
    correlation = intraclass(np.array([[each.a, each.b] for each in differences]))
    maximum = maximum_error(first.accuracy_class, first.unit)
    return Agreement(
        key=first.key,
        name=first.name,
        unit=first.unit,
        accuracy_class=first.accuracy_class,
        subjects=len(values),
        mean=fmean(values),
        deviation=stdev(values) if len(values) > 1 else None,
        low=None if interval is None else interval[0],
        high=None if interval is None else interval[1],
        lower_limit=None if limits is None else limits.lower,
        upper_limit=None if limits is None else limits.upper,
        limit_half_width=None if limits is None else limits.half_width,
        icc=None if correlation is None else correlation.agreement,
        icc_low=None if correlation is None else correlation.low,
        icc_high=None if correlation is None else correlation.high,
        icc_consistency=None if correlation is None else correlation.consistency,
        largest=largest.difference,
        largest_subject=largest.subject,
        maximum_error=maximum,
        verdict=_verdict(interval, maximum, len(values), minimum_subjects),
    )


def maximum_error(accuracy_class: str | None, unit: str) -> float | None:
    """Return the maximum allowable error of a class in a unit of length; None without a class."""
    if accuracy_class is None:
        return None
    millimeters = AccuracyClass(accuracy_class).maximum_error_mm
    return convert_length(millimeters, Unit.MM, Unit.parse(unit))


def _verdict(
    interval: tuple[float, float] | None, maximum: float | None, count: int, minimum: int
) -> Verdict:
    if maximum is None:
        return "no class"
    if interval is None or count < minimum:
        return "too few subjects"
    low, high = interval
    if -maximum <= low and high <= maximum:
        return "within"
    # An interval that reaches beyond the limits because it is wide tells nothing. With as many
    # subjects as the standard asks for, it takes even that for too large a difference.
    beyond = low > maximum or high < -maximum
    return "exceeds" if beyond or count >= MINIMUM_SUBJECTS else "too few subjects"


def class_verdicts(agreements: Sequence[Agreement], unit: str) -> list[ClassVerdict]:
    """Return the verdict on each class that occurs, in the order of the standard."""
    found = []
    for each in AccuracyClass:
        members = [one for one in agreements if one.accuracy_class == each.value]
        if not members:
            continue
        verdicts = {one.verdict for one in members}
        verdict: Verdict = "exceeds" if "exceeds" in verdicts else "too few subjects"
        found.append(
            ClassVerdict(
                accuracy_class=each.value,
                maximum_error=convert_length(each.maximum_error_mm, Unit.MM, Unit.parse(unit)),
                measurements=len(members),
                within=sum(one.verdict == "within" for one in members),
                verdict="within" if verdicts == {"within"} else verdict,
            )
        )
    return found
