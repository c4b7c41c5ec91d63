"""Which patches deserve a closer look."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from bodymeasure.report.patches.from_survey import measurement_records
from bodymeasure.report.patches.records import Document, Measurement

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

# Verdicts under which a length and the mesh contradict each other.
DISAGREEING = ("longer", "shorter")
# Pictures of each kind in a report: a page of each on paper.
WORST_SHOWN = 6
UNMEASURED_SHOWN = 6


def disagreements(document: Document) -> int:
    """How many lengths and mesh distances contradict each other."""
    return sum(document.summary.by_verdict.get(verdict, 0) for verdict in DISAGREEING)


def closeup_patches(survey: "Survey") -> tuple[int, ...]:
    """Numbers of the patches that a report shows a picture of, each once.

    Those with the largest differences, then those with a diagonal that has no length.
    """
    records = measurement_records(survey, survey.atlas.unit, kinds=("diagonal",))
    shown = worst(records)[:WORST_SHOWN] + first_unmeasured(records)[:UNMEASURED_SHOWN]
    return tuple(dict.fromkeys(record.patch_number for record in shown))


def worst(records: Sequence[Measurement]) -> list[Measurement]:
    """Measured diagonals from worst to best, one a patch.

    By relative difference from the mesh, those that disagree with it first; without a cross-check
    by relative error estimate.
    """
    diagonals = [r for r in records if r.kind == "diagonal" and r.length is not None]
    return _one_a_patch(sorted(diagonals, key=_badness, reverse=True))


def first_unmeasured(records: Sequence[Measurement]) -> list[Measurement]:
    """Diagonals without a length in the order of the atlas, one a patch."""
    return _one_a_patch([r for r in records if r.kind == "diagonal" and r.length is None])


def _badness(record: Measurement) -> tuple[bool, float, float]:
    relative_error = (record.error_estimate or 0.0) / (record.length or 1.0)
    difference = -1.0 if record.relative_difference is None else abs(record.relative_difference)
    return record.verdict in DISAGREEING, difference, relative_error


def _one_a_patch(records: Sequence[Measurement]) -> list[Measurement]:
    first: dict[int, Measurement] = {}
    for record in records:
        first.setdefault(record.patch_number, record)
    return list(first.values())
