"""The files of patterns, and what each of them needs."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from bodymeasure.cli.options import names_in_list
from bodymeasure.wording import hint

if TYPE_CHECKING:
    from bodymeasure.pattern import GradedPattern, Pattern

# What can be asked for, and the file that it is.
FORMATS = {
    "html": "pattern.html",
    "svg": "pattern.svg",
    "pdf": "pattern.pdf",
    "dxf": "pattern.dxf",
    "garmentcode": "garmentcode.json",
    "strain": "strain.svg",
    "json": "pattern.json",
}
# Feature, module, package and extra of each format that needs more than pieces do.
NEEDS = {
    "html": (
        ("the page of a pattern", "jinja2", "jinja2", "pattern"),
        ("pictures of panels", "matplotlib", "matplotlib", "pattern"),
    ),
    "pdf": (("the PDF file", "reportlab", "reportlab", "pattern"),),
    "dxf": (("the DXF file", "ezdxf", "ezdxf", "pattern"),),
}


def formats(_ctx: click.Context, _parameter: click.Parameter, text: str | None) -> tuple[str, ...]:
    """Return the formats in a list with commas; all of them if none was given.

    Raises
    ------
    click.BadParameter
        If one is unknown.
    """
    names = names_in_list(text) or tuple(FORMATS)
    for name in names:
        if name not in FORMATS:
            raise click.BadParameter(f"no format is named {name!r}; {hint(name, [*FORMATS])}.")
    return tuple(name for name in FORMATS if name in names)


def needs_of(wanted: tuple[str, ...]) -> list[tuple[str, str, str, str]]:
    """Return what has to be installed for formats."""
    return [need for name in wanted for need in NEEDS.get(name, ())]


def files_of(
    made: "Pattern", folder: Path, wanted: tuple[str, ...], *, allowance: float, paper: str
) -> dict[Path, bytes]:
    """Return the files of a pattern; the allowance is in millimeters."""
    from bodymeasure.pattern import pattern_garmentcode, pattern_json, strain_svg

    found = _drawings(made, wanted, allowance, paper)
    if "garmentcode" in wanted:
        found["garmentcode"] = pattern_garmentcode(made)
    if "strain" in wanted:
        found["strain"] = strain_svg(made).encode()
    if "json" in wanted:
        found["json"] = pattern_json(made, allowance=allowance)
    if "html" in wanted:
        found["html"] = _page(made, tuple(FORMATS[name] for name in found), allowance)
    return {folder / FORMATS[name]: found[name] for name in wanted}


def nested_files(
    made: "GradedPattern", folder: Path, wanted: tuple[str, ...], *, allowance: float, paper: str
) -> dict[Path, bytes]:
    """Return the files that hold all sizes over each other; the allowance is in millimeters."""
    found = _drawings(made, wanted, allowance, paper)
    return {folder / FORMATS[name]: content for name, content in found.items()}


def _drawings(
    made: "Pattern | GradedPattern", wanted: tuple[str, ...], allowance: float, paper: str
) -> dict[str, bytes]:
    from bodymeasure.pattern import pattern_dxf, pattern_pdf, pattern_svg

    found = {}
    if "svg" in wanted:
        found["svg"] = pattern_svg(made, allowance=allowance).encode()
    if "pdf" in wanted:
        found["pdf"] = pattern_pdf(made, allowance=allowance, paper=paper)
    if "dxf" in wanted:
        found["dxf"] = pattern_dxf(made, allowance=allowance)
    return found


def _page(made: "Pattern", beside: tuple[str, ...], allowance: float) -> bytes:
    from bodymeasure.report.patterns import render_pattern
    from bodymeasure.scene.panels.pictures import panel_pictures

    return render_pattern(made, panel_pictures(made), allowance=allowance, files=beside)
