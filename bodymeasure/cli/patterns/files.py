"""Which files of patterns to write, and what each of them needs."""

import click

from bodymeasure.cli.options import names_in_list
from bodymeasure.wording import hint

# What can be asked for, for the help.
FORMATS = ("html", "svg", "pdf", "dxf", "garmentcode", "strain", "json")
PAPERS = ("a4", "letter", "a0")
# Feature, module, package and extra of each format that needs more than pieces do.
NEEDS = {
    "html": (
        ("the page of a pattern", "jinja2", "jinja2", "pattern"),
        ("pictures of panels", "matplotlib", "matplotlib", "pattern"),
    ),
    "pdf": (("the PDF file", "reportlab", "reportlab", "pattern"),),
    "dxf": (("the DXF file", "ezdxf", "ezdxf", "pattern"),),
}

formats_option = click.option(
    "--formats",
    callback=lambda _ctx, _parameter, value: _formats(value),
    metavar="NAMES",
    help=f"Which files to write, with commas between them: {', '.join(FORMATS)}.  [default: all]",
)
paper_option = click.option(
    "--paper",
    type=click.Choice(PAPERS),
    default=PAPERS[0],
    show_default=True,
    help="Paper of pattern.pdf: tiles to be glued together, or one sheet (a0).",
)


def _formats(text: str | None) -> tuple[str, ...]:
    names = names_in_list(text) or FORMATS
    for name in names:
        if name not in FORMATS:
            raise click.BadParameter(f"no format is named {name!r}; {hint(name, FORMATS)}.")
    return names


def needs_of(formats: tuple[str, ...]) -> list[tuple[str, str, str, str]]:
    """Return what has to be installed for formats."""
    return [need for name in formats for need in NEEDS.get(name, ())]
