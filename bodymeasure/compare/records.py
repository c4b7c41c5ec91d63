"""The content of a comparison, for JSON and CSV."""

from typing import Annotated, Final, Literal

from msgspec import Meta, Struct

from bodymeasure.report.serial import records_csv
from bodymeasure.report.units import LengthUnit, ValueUnit

SCHEMA: Final = "bodymeasure comparison"

Verdict = Literal["within", "exceeds", "too few subjects", "no class"]
VERDICTS: Final[dict[str, str]] = {
    "within": "The 95 % confidence interval of the mean difference lies within the maximum "
    "allowable error.",
    "exceeds": "The 95 % confidence interval of the mean difference does not lie within the "
    "maximum allowable error.",
    "too few subjects": "The subjects are too few to tell: the standard asks for more, or the "
    "interval is so wide that it lies neither within the maximum allowable error nor beyond it.",
    "no class": "The standard has no class for the measurement.",
}


class Difference(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement of one subject, in both sources."""

    subject: str
    key: str
    name: str
    unit: ValueUnit
    a: Annotated[float, Meta(description="Value in the first source.")]
    b: Annotated[float, Meta(description="Value in the second source.")]
    difference: Annotated[float, Meta(description="a - b")]
    relative: Annotated[float | None, Meta(description="(a - b) / b; null if b is 0.")]
    combined_error: Annotated[
        float | None,
        Meta(description="Sum of the known errors of a and b; null if neither is known."),
    ]
    accuracy_class: Annotated[str | None, Meta(description="Class in ISO 20685-1.")]


class Agreement(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The differences of one measurement over all subjects."""

    key: str
    name: str
    unit: ValueUnit
    accuracy_class: str | None
    subjects: int
    mean: Annotated[float, Meta(description="Mean difference a - b.")]
    deviation: Annotated[float | None, Meta(description="Sample standard deviation.")]
    low: Annotated[float | None, Meta(description="Lower end of the 95 % interval of the mean.")]
    high: Annotated[float | None, Meta(description="Upper end of the 95 % interval of the mean.")]
    lower_limit: Annotated[
        float | None,
        Meta(description="Lower limit of agreement (Bland and Altman): mean - 1.96 deviations."),
    ]
    upper_limit: Annotated[
        float | None,
        Meta(description="Upper limit of agreement: mean + 1.96 deviations."),
    ]
    limit_half_width: Annotated[
        float | None,
        Meta(description="Half of the width of the 95 % interval of each limit of agreement."),
    ]
    icc: Annotated[
        float | None,
        Meta(description="Intra-class correlation ICC(A,1): of absolute agreement."),
    ]
    icc_low: Annotated[float | None, Meta(description="Lower end of its 95 % interval.")]
    icc_high: Annotated[float | None, Meta(description="Upper end of its 95 % interval.")]
    icc_consistency: Annotated[
        float | None,
        Meta(
            description="Intra-class correlation ICC(C,1), for which a constant difference does "
            "not count."
        ),
    ]
    largest: Annotated[float, Meta(description="The difference that is largest in size.")]
    largest_subject: str
    maximum_error: Annotated[
        float | None, Meta(description="Maximum allowable error of the class in ISO 20685-1.")
    ]
    verdict: Verdict


class ClassVerdict(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A class of ISO 20685-1, which is within if each of its measurements is."""

    accuracy_class: str
    maximum_error: float
    measurements: int
    within: Annotated[int, Meta(description="Measurements that are within.")]
    verdict: Verdict


class Comparison(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The comparison of two sources of body measurements."""

    schema: Annotated[Literal["bodymeasure comparison"], Meta(description="Kind of file.")] = SCHEMA
    version: Annotated[Literal[1], Meta(description="The version of this layout.")] = 1
    created: Annotated[str, Meta(description="The time at which it was made, in ISO 8601.")]
    a: Annotated[str, Meta(description="The first source.")]
    b: Annotated[str, Meta(description="The second source.")]
    unit: Annotated[LengthUnit, Meta(description="Unit of the lengths.")]
    minimum_subjects: Annotated[int, Meta(description="Number of subjects that a verdict needs.")]
    subjects: Annotated[list[str], Meta(description="Those in both sources.")]
    classes: list[ClassVerdict]
    agreements: list[Agreement]
    notes: Annotated[list[str], Meta(description="What could not be compared, and why.")]
    differences: list[Difference]


def comparison_to_csv(comparison: Comparison) -> bytes:
    """Return the differences as CSV (RFC 4180, UTF-8), with the fields of `Difference`."""
    return records_csv(Difference, comparison.differences)
