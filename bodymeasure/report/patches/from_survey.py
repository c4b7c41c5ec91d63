"""The numbers of a survey as records: units are converted, and numbers not finite become null."""

from collections import Counter
from collections.abc import Iterable
from datetime import UTC, datetime
from enum import Enum
from math import isfinite
from statistics import median
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from msgspec import UNSET
from numpy.typing import NDArray

from bodymeasure.atlas import EDGES, Approximation, Unit, approximation_sentences, convert_length
from bodymeasure.report.patches.records import Document, Finding, Kind, PatchRecord, Spread, Summary

if TYPE_CHECKING:
    from bodymeasure._typing import Array
    from bodymeasure.measure import Survey

ALL_KINDS: tuple[Kind, ...] = ("diagonal", "boundary")


def measurement_records(
    survey: "Survey", unit: Unit | str, *, kinds: tuple[Kind, ...] = ALL_KINDS
) -> list[PatchRecord]:
    """Return one record for each length of a survey: by patch, diagonals before sides.

    Parameters
    ----------
    survey : Survey
    unit : Unit or str
        Unit of the records.
    kinds : tuple of "diagonal", "boundary"
    """
    unit = Unit.parse(unit)
    diagonals = _diagonals(survey, unit) if "diagonal" in kinds else []
    sides = _sides(survey, unit) if "boundary" in kinds else []
    # The sort is stable, so that the diagonals of each patch stay before its sides.
    return sorted([*diagonals, *sides], key=lambda record: record.patch_number)


def survey_document(
    survey: "Survey",
    unit: Unit | str,
    *,
    kinds: tuple[Kind, ...] = ALL_KINDS,
    created: datetime | None = None,
) -> Document:
    """Return all that a survey found, as the content of ``measurements.json``.

    Parameters
    ----------
    survey : Survey
    unit : Unit or str
    kinds : tuple of "diagonal", "boundary"
    created : datetime, optional
        The time that the document states; the present if not given.
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
        approximation=list(approximation_sentences(atlas, unit)) or UNSET,
        versions={str(key): str(value) for key, value in survey.versions.items()},
        seconds={str(key): float(value) for key, value in survey.seconds.items()},
        statuses=_meanings(np.asarray(survey.diagonals.status)),
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


def _diagonals(survey: "Survey", unit: Unit) -> list[PatchRecord]:
    atlas, solution, check = survey.atlas, survey.diagonals, survey.cross_check
    start, end = np.asarray(solution.start).tolist(), np.asarray(solution.end).tolist()
    # The property makes the array anew at each access.
    contacts, status = solution.contacts, np.asarray(solution.status)
    lengths = {name: getattr(solution, name) for name in ("length", "error_estimate", "raw_length")}
    plain = {"residual": solution.residual}
    if check is not None:
        compared = ("exact", "exact_uncertainty", "difference", "heat")
        lengths |= {name: getattr(check, name) for name in compared}
        plain["relative_difference"] = check.relative_difference
    if atlas.approximation is not None:
        lengths |= _costs(atlas.approximation, lengths["length"])
    plain |= {name: convert_length(each, atlas.unit, unit) for name, each in lengths.items()}
    columns: dict[str, list[list[Any]]] = {name: _finite(each) for name, each in plain.items()}
    columns["proven_shortest"] = solution.proven_shortest.tolist()
    columns["functions"] = solution.functions.tolist()
    columns["iterations"] = solution.iterations.tolist()
    return [
        PatchRecord(
            name=f"{atlas.patch_names[patch]} diagonal {number + 1}",
            kind="diagonal",
            patch=atlas.patch_names[patch],
            patch_number=patch,
            region=atlas.regions[patch],
            start=tuple(start[patch][number]),
            end=tuple(end[patch][number]),
            unit=unit.value,
            status=status[patch, number].name.lower(),
            contacts="; ".join(
                f"{contact.edge} from {contact.start:.6g} to {contact.end:.6g}"
                for contact in contacts[patch, number]
            )
            or None,
            verdict=None if check is None else check.verdict[patch, number].name.lower(),
            exact_by=None if check is None else _engine(bool(check.confirmed[patch])),
            **{name: values[patch][number] for name, values in columns.items()},
        )
        for patch in range(len(atlas))
        for number in range(2)
    ]


def _engine(confirmed: bool) -> Literal["libigl", "edge flips"]:
    return "libigl" if confirmed else "edge flips"


def _sides(survey: "Survey", unit: Unit) -> list[PatchRecord]:
    atlas, boundary = survey.atlas, survey.boundary
    length = _finite(convert_length(boundary.length, atlas.unit, unit))
    costs: dict[str, Any] = {}
    if atlas.approximation is not None:
        costs = {
            name: _finite(convert_length(each, atlas.unit, unit))
            for name, each in _costs(atlas.approximation, boundary.length).items()
        }
    error = _finite(convert_length(boundary.error_estimate, atlas.unit, unit))
    records = []
    for patch in range(len(atlas)):
        for number, edge in enumerate(EDGES):
            ends = [[0.0, 0.0], [1.0, 1.0]]
            for point in ends:
                point[edge.fixed_axis] = edge.fixed_value
            records.append(
                PatchRecord(
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
                    # The length of a side is an integral, with no equation to solve.
                    status="not_converged" if length[patch][number] is None else "converged",
                    **{name: values[patch][number] for name, values in costs.items()},
                )
            )
    return records


def _costs(approximation: Approximation, lengths: "Array") -> dict[str, "Array"]:
    """Return what the approximation costs lengths (patches, k): their errors and differences."""
    return {
        "approximation_error": approximation.stretch[:, None] * lengths,
        "mesh_difference": approximation.mesh_lengths * lengths,
    }


def _finite(values: "Array") -> list[list[float | None]]:
    values = np.asarray(values, dtype=np.float64)
    return [[value if isfinite(value) else None for value in row] for row in values.tolist()]


def _meanings(members: NDArray[np.object_]) -> dict[str, str]:
    """Return the sentence of each member that occurs, in the order of their definition."""
    present: set[Enum] = set(members.ravel().tolist())
    return {
        member.name.lower(): str(member.value)
        for kind in {type(member) for member in present}
        for member in kind
        if member in present
    }


def _summary(patches: int, diagonals: list[PatchRecord]) -> Summary:
    compared = [m for m in diagonals if m.relative_difference is not None]
    worst = max(compared, key=lambda m: abs(m.relative_difference or 0.0), default=None)
    return Summary(
        patches=patches,
        diagonals=len(diagonals),
        measured=sum(m.length is not None for m in diagonals),
        proven_shortest=sum(bool(m.proven_shortest) for m in diagonals),
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
