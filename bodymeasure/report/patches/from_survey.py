"""A survey's numbers as records: unit converted, numbers that are not finite turned to null."""

import math
from collections import Counter
from collections.abc import Iterable
from datetime import UTC, datetime
from enum import Enum
from statistics import median
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import EDGES, Unit, convert_length
from bodymeasure.report.patches.records import Document, Finding, Kind, Measurement, Spread, Summary

if TYPE_CHECKING:
    from bodymeasure.geodesic import EdgeContact
    from bodymeasure.measure import Survey

ALL_KINDS: tuple[Kind, ...] = ("diagonal", "boundary")


def measurement_records(
    survey: "Survey", unit: Unit | str, *, kinds: tuple[Kind, ...] = ALL_KINDS
) -> list[Measurement]:
    """One record for each length of a survey: by patch, diagonals before sides.

    Parameters
    ----------
    survey : Survey
    unit : Unit or str
        Unit of the records.
    kinds : tuple of "diagonal", "boundary"
    """
    unit = Unit.parse(unit)
    diagonals = _diagonals(survey, unit) if "diagonal" in kinds else []
    boundary = _boundary(survey, unit) if "boundary" in kinds else []
    # The sort is stable, so each patch keeps diagonals first.
    return sorted([*diagonals, *boundary], key=lambda record: record.patch_number)


def survey_document(
    survey: "Survey",
    unit: Unit | str,
    *,
    kinds: tuple[Kind, ...] = ALL_KINDS,
    created: datetime | None = None,
) -> Document:
    """All that a survey found, as the content of ``measurements.json``.

    Parameters
    ----------
    survey : Survey
    unit : Unit or str
    kinds : tuple of "diagonal", "boundary"
    created : datetime, optional
        Now if not given.
    """
    atlas, check = survey.atlas, survey.cross_check
    measurements = measurement_records(survey, unit, kinds=kinds)
    return Document(
        name=atlas.name,
        created=(created or datetime.now(UTC)).isoformat(timespec="seconds"),
        unit=Unit.parse(unit).value,
        atlas_digest=atlas.digest,
        provenance={str(key): str(value) for key, value in atlas.provenance.items()},
        settings={str(key): str(value) for key, value in survey.settings.items()},
        versions={str(key): str(value) for key, value in survey.versions.items()},
        seconds={str(key): float(value) for key, value in survey.seconds.items()},
        statuses=_meanings(survey.diagonals.status),
        verdicts={} if check is None else _meanings(check.verdict),
        summary=_summary(len(atlas), [m for m in measurements if m.kind == "diagonal"]),
        findings=[
            Finding(
                kind=finding.kind.value,
                severity=finding.severity.value,
                patches=[atlas.patch_names[patch] for patch in finding.patches],
                message=finding.message,
            )
            for finding in survey.findings
        ],
        measurements=measurements,
    )


def code(member: Enum) -> str:
    """The short name of a status or verdict: lower case, as it stands in the files."""
    return member.name.lower()


def _diagonals(survey: "Survey", unit: Unit) -> list[Measurement]:
    atlas, solution, check = survey.atlas, survey.diagonals, survey.cross_check

    def lengths(values: NDArray[np.float64]) -> list[list[float | None]]:
        return _finite(convert_length(values, atlas.unit, unit))

    empty: list[list[None]] = [[None, None]] * len(atlas)
    columns: dict[str, list[list[float | None]] | list[list[None]] | list[list[int]]] = {
        "length": lengths(solution.length),
        "error_estimate": lengths(solution.error_estimate),
        "raw_length": lengths(solution.raw_length),
        "residual": _finite(solution.residual),
        "functions": solution.functions.tolist(),
        "iterations": solution.iterations.tolist(),
        "exact": empty if check is None else lengths(check.exact),
        "exact_uncertainty": empty if check is None else lengths(check.exact_uncertainty),
        "difference": empty if check is None else lengths(check.difference),
        "relative_difference": empty if check is None else _finite(check.relative_difference),
        "heat": empty if check is None else lengths(check.heat),
    }
    contacts = solution.contacts
    start, end = np.asarray(solution.start).tolist(), np.asarray(solution.end).tolist()
    return [
        Measurement(
            name=f"{atlas.patch_names[patch]} diagonal {number + 1}",
            kind="diagonal",
            patch=atlas.patch_names[patch],
            patch_number=patch,
            region=atlas.regions[patch],
            start=(start[patch][number][0], start[patch][number][1]),
            end=(end[patch][number][0], end[patch][number][1]),
            unit=unit.value,
            status=code(solution.status[patch, number]),
            contacts=_contacts(contacts[patch, number]),
            verdict=None if check is None else code(check.verdict[patch, number]),
            **{key: values[patch][number] for key, values in columns.items()},  # type: ignore[arg-type]
        )
        for patch in range(len(atlas))
        for number in range(2)
    ]


def _contacts(contacts: "tuple[EdgeContact, ...]") -> str | None:
    words = [f"{each.edge} from {each.start:.6g} to {each.end:.6g}" for each in contacts]
    return "; ".join(words) or None


def _boundary(survey: "Survey", unit: Unit) -> list[Measurement]:
    atlas = survey.atlas
    length = _finite(convert_length(survey.boundary.length, atlas.unit, unit))
    error = _finite(convert_length(survey.boundary.error_estimate, atlas.unit, unit))
    records = []
    for patch in range(len(atlas)):
        for number, edge in enumerate(EDGES):
            ends = [[0.0, 0.0], [1.0, 1.0]]
            for point in ends:
                point[edge.fixed_axis] = edge.fixed_value
            records.append(
                Measurement(
                    name=f"{atlas.patch_names[patch]} side {edge.name}",
                    kind="boundary",
                    patch=atlas.patch_names[patch],
                    patch_number=patch,
                    region=atlas.regions[patch],
                    start=(ends[0][0], ends[0][1]),
                    end=(ends[1][0], ends[1][1]),
                    length=length[patch][number],
                    unit=unit.value,
                    error_estimate=error[patch][number],
                    # A side's length is an integral, with no equation to solve.
                    status="not_converged" if length[patch][number] is None else "converged",
                )
            )
    return records


def _finite(values: NDArray[np.float64]) -> list[list[float | None]]:
    return [
        [value if math.isfinite(value) else None for value in row]
        for row in np.asarray(values, dtype=np.float64).tolist()
    ]


def _meanings(members: NDArray[np.object_]) -> dict[str, str]:
    """The sentence of each member that occurs, in the order of their definition."""
    present: set[Enum] = set(members.ravel().tolist())
    return {
        code(member): str(member.value)
        for kind in {type(member) for member in present}
        for member in kind
        if member in present
    }


def _summary(patches: int, diagonals: list[Measurement]) -> Summary:
    compared = [m for m in diagonals if m.relative_difference is not None]
    worst = max(compared, key=lambda m: abs(m.relative_difference or 0.0), default=None)
    return Summary(
        patches=patches,
        diagonals=len(diagonals),
        measured=sum(m.length is not None for m in diagonals),
        by_status=dict(Counter(m.status for m in diagonals)),
        by_verdict=dict(Counter(m.verdict for m in diagonals if m.verdict is not None)),
        length=_spread(m.length for m in diagonals),
        error_estimate=_spread(m.error_estimate for m in diagonals if m.length is not None),
        difference=_spread(m.difference for m in diagonals),
        relative_difference=_spread(m.relative_difference for m in diagonals),
        worst=None if worst is None else worst.name,
    )


def _spread(values: Iterable[float | None]) -> Spread:
    sizes = sorted(abs(value) for value in values if value is not None)
    if not sizes:
        return Spread(count=0)
    return Spread(count=len(sizes), minimum=sizes[0], median=median(sizes), maximum=sizes[-1])
