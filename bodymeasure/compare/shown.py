"""Differences as people read them on the page and in the terminal."""

from collections import Counter
from statistics import median

from bodymeasure.compare.records import Agreement, Comparison, Difference
from bodymeasure.report.body.tape import small_text
from bodymeasure.report.numbers import MINUS, NONE, SPACE
from bodymeasure.report.units import DEGREES, TAPE_DECIMALS
from bodymeasure.wording import counted

# One decimal more than a tape shows, since differences are means of many readings.
EXTRA_DECIMALS = 1
# The verdicts as a sentence counts them.
OUTCOMES = {
    "within": "within what is allowed",
    "exceeds": "beyond it",
    "too few subjects": "with too few subjects to tell",
    "no class": "without a class",
}


def signed(value: float | None, unit: str) -> str:
    """Return a difference with its sign, one digit finer than a tape; a dash for None."""
    if value is None:
        return NONE
    text = f"{value:+.{TAPE_DECIMALS[unit] + EXTRA_DECIMALS}f}"
    if float(text) == 0.0:
        return text[1:]
    return text.replace("-", MINUS)


def error_text(difference: Difference) -> str:
    """Return the combined error of a difference with its unit; a dash for None."""
    error = difference.combined_error
    if difference.unit == DEGREES:
        return NONE if error is None else f"{error:.1g}°"
    return small_text(error, difference.unit)


def interval(agreement: Agreement) -> str:
    """Return the confidence interval of a mean difference; a dash for None."""
    if agreement.low is None or agreement.high is None:
        return NONE
    low, high = (signed(end, agreement.unit) for end in (agreement.low, agreement.high))
    return f"{low}{SPACE}to {high}"


def limits(agreement: Agreement) -> str:
    """Return the limits of agreement; a dash for None."""
    if agreement.lower_limit is None or agreement.upper_limit is None:
        return NONE
    ends = (agreement.lower_limit, agreement.upper_limit)
    low, high = (signed(end, agreement.unit) for end in ends)
    return f"{low}{SPACE}to {high}"


def icc(agreement: Agreement) -> str:
    """Return the intra-class correlation of agreement; a dash for None."""
    return correlation(agreement.icc)


def icc_interval(agreement: Agreement) -> str:
    """Return the confidence interval of the intra-class correlation; empty for None."""
    if agreement.icc_low is None or agreement.icc_high is None:
        return ""
    return f"{correlation(agreement.icc_low)}{SPACE}to {correlation(agreement.icc_high)}"


def correlation(value: float | None) -> str:
    """Return a coefficient, never rounded up to 1; a dash for None."""
    if value is None:
        return NONE
    text = f"{value:.3f}"
    text = "0.999" if value < 1.0 and text == "1.000" else text
    return text.replace("-", MINUS)


def summary(comparison: Comparison) -> list[str]:
    """Return what a comparison comes to, in sentences."""
    agreements = comparison.agreements
    count = counted(len(agreements), "measurement")
    lengths = [each for each in agreements if each.unit != DEGREES]
    sentences = []
    if len(comparison.subjects) == 1:
        sentences.append(f"{count} of one subject compared.")
    else:
        verdicts: Counter[str] = Counter(each.verdict for each in agreements)
        said = ", ".join(
            f"{verdicts[verdict]} {words}"
            for verdict, words in OUTCOMES.items()
            if verdicts[verdict]
        )
        sentences.append(f"{count} of {len(comparison.subjects)} subjects compared: {said}.")
    if lengths:
        largest = max(lengths, key=lambda each: abs(each.mean))
        middle = median(abs(each.mean) for each in lengths)
        mean = "" if len(comparison.subjects) == 1 else "mean "
        sentences.append(
            f"The largest {mean}difference of a length is {signed(largest.mean, largest.unit)} "
            f"{largest.unit} ({largest.name}); half of them are at most "
            f"{signed(middle, comparison.unit).lstrip('+')} {comparison.unit}."
        )
        beyond = [
            each
            for each in lengths
            if each.maximum_error is not None and abs(each.mean) > each.maximum_error
        ]
        sentences.append(
            f"{len(beyond)} of {len(lengths)} {mean}differences are larger than ISO 20685-1 allows "
            "for the mean of many subjects"
            + ("; those of a single one may be larger." if mean == "" else ".")
        )
    return sentences
