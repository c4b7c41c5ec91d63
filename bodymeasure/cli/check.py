"""`bodymeasure check`."""

from __future__ import annotations

import click
from rich.markup import escape

from bodymeasure.atlas import Severity, check_atlas
from bodymeasure.cli.console import RESULTS
from bodymeasure.cli.options import atlas_argument, load_atlas

EXIT_FOUND_ERRORS = 1
COLORS = {Severity.ERROR: "bold red", Severity.WARNING: "yellow"}


@click.command()
@atlas_argument
def check(atlas: str) -> int:
    """Say what is wrong with ATLAS: gaps in seams, folds, collapsed edges, kinks, ...

    Exit code 1 if there are errors, 0 if there are none (warnings do not count).
    """
    loaded = load_atlas(atlas)
    findings = check_atlas(loaded)
    for finding in findings:
        color = COLORS[finding.severity]
        RESULTS.print(
            f"[{color}]{finding.severity}[/] {finding.kind}: {escape(finding.message)}",
            soft_wrap=True,
        )
    errors = sum(finding.severity == Severity.ERROR for finding in findings)
    RESULTS.print(
        f"{escape(loaded.name or atlas)}: {len(loaded)} patches in {loaded.unit}, "
        f"{errors} errors, {len(findings) - errors} warnings",
        soft_wrap=True,
    )
    return EXIT_FOUND_ERRORS if errors else 0
