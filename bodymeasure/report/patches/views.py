"""The content of a document, arranged and put into words for the page."""

import re
from collections import Counter
from dataclasses import dataclass

from bodymeasure.report.numbers import NONE, at_most, length_text, millimeters, scientific
from bodymeasure.report.patches.ranking import (
    UNMEASURED_SHOWN,
    WORST_SHOWN,
    disagreements,
    first_unmeasured,
    worst,
)
from bodymeasure.report.patches.records import Document, Finding, PatchRecord
from bodymeasure.report.units import UNIT_NAMES
from bodymeasure.wording import counted

# Statuses in the words of a table, beside which the page has sentences.
LABELS = {
    "converged": "measured",
    "on_boundary": "measured, along an edge",
    "leaves_patch": "leaves the patch",
    "not_a_minimum": "not a shortest path",
    "singular": "singular equations",
}

# Statuses that come with a length.
MEASURED = ("converged", "on_boundary")

# The number of findings on the page. A broken atlas may have thousands; measurements.json has all.
FINDINGS_SHOWN = 40


@dataclass(frozen=True)
class StatusRow:
    """A status: its mark, its words and sentence, and how many diagonals have it."""

    code: str
    label: str
    mark: str
    tone: str
    sentence: str
    count: int


@dataclass(frozen=True)
class PatchRow:
    """The lengths of one patch."""

    number: int
    name: str
    diagonals: tuple[PatchRecord, ...]
    sides: tuple[PatchRecord, ...]


@dataclass(frozen=True)
class Region:
    """The patches of one body region, and the numbers of their diagonals."""

    name: str
    anchor: str
    patches: tuple[PatchRow, ...]
    measured: int
    diagonals: int
    largest: PatchRecord | None


def diagonals(document: Document) -> list[PatchRecord]:
    """Return the diagonals of a document."""
    return [m for m in document.measurements if m.kind == "diagonal"]


def has_check(document: Document) -> bool:
    """Return whether a cross-check was made."""
    return bool(document.verdicts)


def status_rows(document: Document) -> dict[str, StatusRow]:
    """Return each status that occurs, by its code."""
    counts = document.summary.by_status
    return {
        code: StatusRow(
            code=code,
            label=LABELS.get(code, code.replace("_", " ")),
            mark={"converged": "✓", "on_boundary": "✓", "leaves_patch": "△"}.get(code, "✕"),
            tone={"converged": "good", "on_boundary": "good", "leaves_patch": "fair"}.get(
                code, "poor"
            ),
            sentence=sentence,
            count=counts.get(code, 0),
        )
        for code, sentence in document.statuses.items()
    }


def tiles(document: Document) -> list[tuple[str, str, str]]:
    """Return the key figures, each with a heading and a remark."""
    summary, unit = document.summary, document.unit
    spread = summary.length
    lengths = f"{length_text(spread.minimum, unit)} to {length_text(spread.maximum, unit)}"
    return [
        ("Diagonals measured", f"{summary.measured} of {summary.diagonals}", ""),
        (
            "Median length",
            f"{length_text(spread.median, unit)} {unit}" if spread.count else NONE,
            lengths if spread.count else "",
        ),
        (
            "Median difference",
            millimeters(summary.difference.median, unit),
            "from the mesh check" if has_check(document) else "no mesh check was made",
        ),
        (
            "Largest difference",
            millimeters(summary.difference.maximum, unit),
            "from the mesh check" if has_check(document) else "no mesh check was made",
        ),
    ]


def summary_sentences(document: Document) -> list[str]:
    """Return the results in sentences that need no knowledge of the method."""
    summary = document.summary
    sentences = [
        f"The body is covered by {counted(summary.patches, 'patch', 'patches')}. On each, the "
        "shortest way that was found over the skin was measured between both pairs of opposite "
        "corners (the diagonals), and so were the four sides. "
        f"All lengths are in {UNIT_NAMES[document.unit]}.",
        _measured(document),
    ]
    costs = document.approximation or ()
    return [*sentences, *_proven(document), *_checked(document), _precision(document), *costs]


def _measured(document: Document) -> str:
    summary = document.summary
    missing = summary.diagonals - summary.measured
    edges = summary.by_status.get("on_boundary", 0)
    run = "runs" if edges == 1 else "run"
    along = (
        f" {edges} of those measured {run} along an edge of the patch in part; on the whole "
        "body, a shorter way may lead over the neighboring patch."
        if edges
        else ""
    )
    if not missing:
        return f"All {counted(summary.diagonals, 'diagonal')} could be measured.{along}"
    reasons = "; ".join(
        f"{row.label}: {row.count}"
        for row in status_rows(document).values()
        if row.code not in MEASURED
    )
    return (
        f"{summary.measured} of {counted(summary.diagonals, 'diagonal')} could be measured; "
        f"{missing} could not and {'has' if missing == 1 else 'have'} no length here "
        f"({reasons}). “Not measured” below lists them with the reasons.{along}"
    )


def _proven(document: Document) -> list[str]:
    proven, measured = document.summary.proven_shortest, document.summary.measured
    if proven is None or not measured:
        return []
    if proven == measured:
        return ["Each is proven to be the only shortest way on its patch."]
    return [
        f"{proven} of these {measured} {'is' if proven == 1 else 'are'} proven to be the only "
        "shortest ways on their patches; of the others, that is not proven."
    ]


def _checked(document: Document) -> list[str]:
    summary = document.summary
    if not has_check(document):
        return ["No cross-check was made: the lengths rest on their own error estimates alone."]
    agrees, disagrees = summary.by_verdict.get("agrees", 0), disagreements(document)
    compared = summary.difference.count
    if not compared:
        return ["The cross-check could not compare any diagonal."]
    sentences = [
        "Each length was checked against the shortest path on fine triangle meshes of the same "
        f"patch, which independent software found: of the {compared} that were compared, "
        + (
            f"{agrees} agree with it and {disagrees} do not; see “Worst cases”."
            if disagrees
            else f"{'all' if agrees == compared else agrees} agree with it."
        )
    ]
    median = summary.difference.median
    sentences.append(
        f"Half of the lengths differ from the check by {at_most(median, document.unit)}, and all "
        f"by {at_most(summary.difference.maximum, document.unit)}. In proportion to its length, "
        f"{summary.worst} differs most: by {scientific(summary.relative_difference.maximum)} "
        "of its length."
    )
    return sentences


def _precision(document: Document) -> str:
    spread = document.summary.error_estimate
    if not spread.count:
        return "No length has an error estimate."
    return (
        "By their own estimates the measured lengths are in error by at most "
        f"{scientific(spread.maximum)} {document.unit}, and half of them by at most "
        f"{scientific(spread.median)} {document.unit}. This is the error of the computation on "
        "this body's surface; it does not include that of the scan or the model from which the "
        "body was made."
    )


def regions(document: Document) -> list[Region]:
    """Return the patches by body region, sorted by name in each."""
    rows: dict[int, list[PatchRecord]] = {}
    for record in document.measurements:
        rows.setdefault(record.patch_number, []).append(record)
    grouped: dict[str, list[PatchRow]] = {}
    for number, records in rows.items():
        row = PatchRow(
            number=number,
            name=records[0].patch,
            diagonals=tuple(r for r in records if r.kind == "diagonal"),
            sides=tuple(r for r in records if r.kind == "boundary"),
        )
        grouped.setdefault(records[0].region, []).append(row)
    return [
        _region(name, f"region-{number}", patches)
        for number, (name, patches) in enumerate(grouped.items(), start=1)
    ]


def _region(name: str, anchor: str, patches: list[PatchRow]) -> Region:
    records = [diagonal for patch in patches for diagonal in patch.diagonals]
    compared = [r for r in records if r.relative_difference is not None]
    return Region(
        name=name or "whole body",
        anchor=anchor,
        patches=tuple(sorted(patches, key=_natural)),
        measured=sum(r.length is not None for r in records),
        diagonals=len(records),
        largest=max(compared, key=lambda r: abs(r.relative_difference or 0.0), default=None),
    )


def _natural(patch: PatchRow) -> list[tuple[bool, int, str]]:
    """Return the key by which names with numbers are sorted as people do: 2-10 after 2-9."""
    words = re.findall(r"\d+|\D+", patch.name)
    return [(word.isdigit(), int(word) if word.isdigit() else 0, word) for word in words]


def worst_cases(document: Document) -> list[PatchRecord]:
    """Return the diagonals to show as worst cases, the worst first."""
    return worst(document.measurements)[:WORST_SHOWN]


def unmeasured(document: Document) -> tuple[list[PatchRecord], list[PatchRecord]]:
    """Return the diagonals without a length: those with a picture, one a patch, and all."""
    records = [m for m in diagonals(document) if m.length is None]
    return first_unmeasured(records)[:UNMEASURED_SHOWN], records


def findings(document: Document) -> tuple[list[Finding], str]:
    """Return the findings to show, errors first, and a sentence on the others."""
    ordered = sorted(document.findings, key=lambda finding: finding.severity != "error")
    shown, left = ordered[:FINDINGS_SHOWN], ordered[FINDINGS_SHOWN:]
    if not left:
        return shown, ""
    kinds = ", ".join(f"{kind}: {n}" for kind, n in Counter(f.kind for f in left).items())
    return shown, f"{counted(len(left), 'more finding')} in measurements.json ({kinds})."
