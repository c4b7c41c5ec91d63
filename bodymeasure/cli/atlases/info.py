"""`bodymeasure info`."""

from collections import Counter

import click
from rich.text import Text

from bodymeasure.atlas import (
    Atlas,
    Finding,
    Severity,
    approximation_sentences,
    check_atlas,
    summarize,
)
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import print_table
from bodymeasure.cli.inputs import load_atlas
from bodymeasure.cli.options import atlas_argument
from bodymeasure.cli.tables import facts_table
from bodymeasure.wording import counted

# The number of names that are listed; the others are counted.
LISTED = 8


@click.command(epilog=EXIT_CODES)
@atlas_argument
def info(atlas: str) -> None:
    """Describe ATLAS: its patches, size and unit, seams, landmarks and quality."""
    loaded = load_atlas(atlas)
    table = facts_table(loaded.name or atlas)
    for label, value in _rows(loaded, check_atlas(loaded)):
        table.add_row(label, Text(value))
    print_table(table)


def _rows(atlas: Atlas, findings: tuple[Finding, ...]) -> list[tuple[str, str]]:
    summary, axes = summarize(atlas), atlas.axes
    unit = f" {summary.unit}"
    rows = [
        ("patches", f"{summary.patches:,}, {counted(summary.control_points, 'control point')}"),
        ("degree", f"{summary.degree}, {'rational' if summary.rational else 'polynomial'}"),
        ("unit", summary.unit.value),
        ("axes", f"up {axes.up}, front {axes.front}"),
        (
            "size",
            f"{summary.height:.4g} high, {summary.width:.4g} wide, {summary.depth:.4g} deep{unit}",
        ),
        (
            "size of patches",
            f"{summary.smallest_patch:.3g} to {summary.largest_patch:.3g}{unit} across",
        ),
        (
            "seams",
            f"{summary.seams:,}; {counted(summary.boundary_edges, 'edge')} on the boundary, "
            f"{summary.collapsed_edges:,} collapsed to a point",
        ),
        ("parts", f"{summary.parts:,}"),
        ("regions", _listed(summary.regions)),
        ("landmarks", _listed(summary.landmarks)),
        ("quality", _quality(findings)),
    ]
    labels = ("approximation", "")
    rows += zip(labels, approximation_sentences(atlas), strict=False)
    return rows + [(key, value) for key, value in atlas.provenance.items()]


def _listed(names: tuple[str, ...]) -> str:
    if not names:
        return "none"
    more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
    return f"{len(names)}: {', '.join(names[:LISTED])}{more}"


def _quality(findings: tuple[Finding, ...]) -> str:
    if not findings:
        return "nothing was found"
    errors = sum(finding.severity == Severity.ERROR for finding in findings)
    kinds = Counter(str(finding.kind) for finding in findings)
    listed = ", ".join(f"{kind} ({times})" for kind, times in kinds.items())
    return (
        f"{counted(errors, 'error')}, {counted(len(findings) - errors, 'warning')}: {listed}; "
        "`bodymeasure check` lists all"
    )
