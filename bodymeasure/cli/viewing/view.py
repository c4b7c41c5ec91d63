"""`bodymeasure view`."""

from pathlib import Path

import click

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.options import (
    DEFAULT_SAMPLE,
    definitions_option,
    despite_errors_option,
    file_options,
    no_cross_check_option,
    processes_option,
)
from bodymeasure.cli.viewing.page import EVERY, Page, show_page

SET_SUFFIX = ".toml"


@click.command(epilog=EXIT_CODES)
@click.argument("atlas", metavar="[ATLAS]", required=False)
@file_options
@click.option(
    "--chart",
    "chart",
    is_flag=False,
    flag_value=EVERY,
    metavar="[SET]",
    help="Show the tapes of the body measurements at once: all, those of a preset such as core, or "
    "of a file of definitions.",
)
@definitions_option
@click.option(
    "--report",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Show what `bodymeasure report -o` or `bodymeasure chart -o` has written there; ATLAS is "
    "found if it lies in the folder, or is a sample.",
)
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    metavar="N",
    help="Port of the page.  [default: a free one]",
)
@click.option(
    "--host",
    default="127.0.0.1",
    show_default=True,
    metavar="ADDRESS",
    help="Address to listen at. Any other than this one lets other machines in, if they know the "
    "link, over a connection that is not encrypted.",
)
@click.option("--no-browser", is_flag=True, help="Print the link, and open no browser.")
@click.option(
    "--desktop",
    is_flag=True,
    help="Open a window of its own (pyvista) instead of a page, with all diagonals or the tapes.",
)
@click.option(
    "--screenshot",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write a picture of what the window shows as a PNG file, and open nothing.",
)
@click.option(
    "--export",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the page as one HTML file that needs no server and no network, and open nothing; "
    "with --chart, with all tapes. It measures nothing itself but straight distances.",
)
@click.option(
    "--measure",
    "key",
    metavar="KEY",
    help="With --chart in the window or a picture: show one measurement alone, by its key.",
)
@no_cross_check_option
@processes_option
@despite_errors_option
def view(
    atlas: str | None,
    chart: str | None,
    definitions: Path | None,
    report: Path | None,
    port: int,
    host: str,
    no_browser: bool,
    desktop: bool,
    screenshot: Path | None,
    export: Path | None,
    key: str | None,
    no_cross_check: bool,
    processes: int,
    despite_errors: bool,
) -> None:
    """Show ATLAS in the browser: turn it, click two points, and read the length between them.

    The page is served to this machine alone, and ends with Ctrl-C. ATLAS is the average female
    sample if not given; a scan is fitted first, as `bodymeasure fit` does.

    With --desktop, a window shows the patches, and the diagonals colored by their difference from
    the mesh, or with --chart the tapes; --screenshot writes a picture of it.
    """
    atlas, chart, definitions = _sorted_out(atlas, chart, definitions)
    if report is None and chart is None and (key is not None or definitions is not None):
        raise click.UsageError("--measure and --set are about measurements; add --chart.")
    if report is not None and (desktop or screenshot is not None or export is not None):
        raise click.UsageError("--report is shown by the page that is served; give it by itself.")
    if export is not None:
        if desktop or screenshot is not None or key is not None:
            raise click.UsageError(
                "--export writes the page; it goes with neither --desktop, --screenshot nor "
                "--measure."
            )
        # Slow imports, which the page does not need.
        from bodymeasure.cli.viewing.export import write_page

        wanted = None if chart is None else (definitions, chart)
        write_page(atlas or DEFAULT_SAMPLE, export, wanted, despite_errors=despite_errors)
        return
    if desktop or screenshot is not None:
        # Slow imports, which the page does not need.
        from bodymeasure.cli.viewing.window import show_window

        show_window(
            atlas or DEFAULT_SAMPLE,
            screenshot,
            None if chart is None else (definitions, chart, key),
            no_cross_check=no_cross_check,
            processes=processes,
            despite_errors=despite_errors,
        )
        return
    if key is not None:
        raise click.UsageError("--measure is for --desktop and --screenshot; search in the page.")
    page = Page(
        chart,
        definitions,
        report,
        host,
        port,
        browser=not no_browser,
        despite_errors=despite_errors,
    )
    show_page(atlas, page)


def _sorted_out(
    atlas: str | None, chart: str | None, definitions: Path | None
) -> tuple[str | None, str | None, Path | None]:
    """Return the atlas, the set and the file of definitions that are meant.

    A name after --chart that is no set is the atlas, as in ``view --chart body.atlas``.
    """
    if chart is not None and chart.lower().endswith(SET_SUFFIX):
        if definitions is not None:
            raise click.UsageError("Give the file of definitions once, with --chart or with --set.")
        chart, definitions = EVERY, Path(chart)
    elif chart not in (None, EVERY):
        from bodymeasure.chart import load_definitions
        from bodymeasure.wording import hint

        presets = load_definitions(definitions).presets
        if chart not in presets:
            if atlas is not None:
                raise click.UsageError(
                    f"--chart {chart!r} is no set of measurements; {hint(str(chart), presets)}"
                )
            atlas, chart = chart, EVERY
    return atlas, chart, definitions
