"""`bodymeasure view --export`: a page in one file, which needs no server."""

from pathlib import Path

import click

from bodymeasure.cli.measuring.measured import measured_chart
from bodymeasure.cli.viewing.page import EVERY, loaded_body, not_installed
from bodymeasure.errors import InputError
from bodymeasure.files import require_writable, write_bytes

SUFFIXES = (".html", ".htm")


def write_page(
    name: str,
    path: Path,
    chart: tuple[Path | None, str] | None,
    *,
    despite_errors: bool,
) -> None:
    """Write the page of a body into a file.

    Parameters
    ----------
    name : str
        The name of a file or a sample that the command was given.
    path : Path
    chart : tuple or None
        The file of definitions and the preset, if the page is to have the measurements.
    despite_errors : bool

    Raises
    ------
    InputError
        If a file cannot be read or written.
    """
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(f"{path}: the page is an HTML file; give a name that ends in .html")
    require_writable(path)
    try:
        from bodymeasure.viewer.content.shown import ShownBody
        from bodymeasure.viewer.page.export import exported
        from bodymeasure.viewer.page.given import Given
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        raise not_installed() from None
    loaded, members = loaded_body(name)
    measured = None
    if chart is not None:
        from bodymeasure.chart import load_definitions

        definitions, preset = chart
        only = () if preset == EVERY else (preset,)
        measured = measured_chart(
            loaded, load_definitions(definitions), only=only, despite_errors=despite_errors
        )
    body = ShownBody(id="0", atlas=loaded, name=loaded.name or Path(name).stem, **members)
    write_bytes(path, exported(Given(body, measured)))
    click.echo(path)
