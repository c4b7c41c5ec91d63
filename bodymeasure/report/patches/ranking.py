"""The patches that deserve a closer look."""

from collections.abc import Sequence

from bodymeasure.report.patches.records import Document, PatchRecord

# Verdicts under which a length and the mesh contradict each other.
DISAGREEING = ("longer", "shorter")
# The number of pictures of each kind in a report, which fills a page of paper.
WORST_SHOWN = 6
UNMEASURED_SHOWN = 6


def disagreements(document: Document) -> int:
    """Return how many lengths and mesh distances contradict each other."""
    return sum(document.summary.by_verdict.get(verdict, 0) for verdict in DISAGREEING)


def closeup_patches(document: Document) -> tuple[int, ...]:
    """Return the numbers of the patches that a report shows a picture of, each once.

    They are those with the largest differences, then those with a diagonal that has no length.
    """
    records = document.measurements
    shown = worst(records)[:WORST_SHOWN] + first_unmeasured(records)[:UNMEASURED_SHOWN]
    return tuple(dict.fromkeys(record.patch_number for record in shown))


def worst(records: Sequence[PatchRecord]) -> list[PatchRecord]:
    """Return the measured diagonals from worst to best, one of each patch.

    They are ordered by their relative difference from the mesh, those that disagree with it first;
    without a cross-check, by their relative error estimate.
    """
    diagonals = [r for r in records if r.kind == "diagonal" and r.length is not None]
    return _one_a_patch(sorted(diagonals, key=_badness, reverse=True))


def first_unmeasured(records: Sequence[PatchRecord]) -> list[PatchRecord]:
    """Return the diagonals without a length in the order of the atlas, one of each patch."""
    return _one_a_patch([r for r in records if r.kind == "diagonal" and r.length is None])


def _badness(record: PatchRecord) -> tuple[bool, float, float]:
    relative_error = (record.error_estimate or 0.0) / (record.length or 1.0)
    difference = -1.0 if record.relative_difference is None else abs(record.relative_difference)
    return record.verdict in DISAGREEING, difference, relative_error


def _one_a_patch(records: Sequence[PatchRecord]) -> list[PatchRecord]:
    first: dict[int, PatchRecord] = {}
    for record in records:
        first.setdefault(record.patch_number, record)
    return list(first.values())
