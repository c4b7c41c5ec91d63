"""`bodymeasure check`."""

import click
from rich.text import Text

from bodymeasure.atlas import Severity, check_atlas
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS
from bodymeasure.cli.inputs import load_atlas
from bodymeasure.cli.options import atlas_argument
from bodymeasure.wording import counted

EXIT_FOUND_ERRORS = 1
COLORS = {Severity.ERROR: "bold red", Severity.WARNING: "yellow"}


@click.command(epilog=EXIT_CODES)
@atlas_argument
def check(atlas: str) -> int:
    """List the faults of ATLAS: gaps in seams, folds, collapsed edges, kinks, wrong axes or size.

    Axes, sides and size are those of a body, as its landmarks show them.
    Errors make lengths wrong, and lead to exit code 1; warnings do not.
    """
    loaded = load_atlas(atlas)
    findings = check_atlas(loaded)
    for finding in findings:
        severity = (str(finding.severity), COLORS[finding.severity])
        line = Text.assemble(severity, f" {finding.kind}: {finding.message}")
        RESULTS.print(line, soft_wrap=True)
    errors = sum(finding.severity == Severity.ERROR for finding in findings)
    RESULTS.print(
        Text(
            f"{loaded.name or atlas}: {counted(len(loaded), 'patch', 'patches')} in "
            f"{loaded.unit}, {counted(errors, 'error')}, "
            f"{counted(len(findings) - errors, 'warning')}"
        ),
        soft_wrap=True,
    )
    return EXIT_FOUND_ERRORS if errors else 0
