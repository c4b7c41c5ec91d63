"""`bodymeasure view`: the page in the browser."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from bodymeasure.atlas import check_sentences
from bodymeasure.cli.console import print_note
from bodymeasure.cli.fitting.files import fitted_in_words
from bodymeasure.cli.fitting.scans import is_scan, require_fit, scan_subject
from bodymeasure.cli.inputs import load_atlas, path_of_atlas
from bodymeasure.cli.needs import require
from bodymeasure.cli.options import DEFAULT_SAMPLE, file_settings
from bodymeasure.errors import InputError
from bodymeasure.formats import read_population
from bodymeasure.samples import sample_names

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Definitions

SERVER = (
    ("the page", "starlette", "starlette", "viewer"),
    ("the page", "uvicorn", "uvicorn", "viewer"),
)
# The key under which the page knows a file of definitions.
OWN, EVERY = "own", "default"


class Page(NamedTuple):
    """What the page begins with, and where it is served.

    Parameters
    ----------
    chart : str or None
        The set of measurements that is shown at once.
    definitions : Path or None
        A file of definitions.
    report : Path or None
        A folder of a report or a chart that is shown at once.
    host : str
    port : int
    browser : bool
    despite_errors : bool
        Whether charts are measured on a body whose landmarks contradict one another.
    """

    chart: str | None
    definitions: Path | None
    report: Path | None
    host: str
    port: int
    browser: bool
    despite_errors: bool


def show_page(name: str | None, page: Page) -> None:
    """Serve the page of a body until it is interrupted.

    Parameters
    ----------
    name : str or None
        The name of a file or a sample that the command was given, if any.
    page : Page

    Raises
    ------
    InputError
        If the file cannot be read, or the server cannot listen.
    """
    require(*SERVER)
    try:
        from bodymeasure.viewer.content.shown import ShownBody
        from bodymeasure.viewer.server.start import is_loopback, serve
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        raise not_installed() from None
    bodies, start, own = _content(name, page)
    body, *others = (
        ShownBody(id="0", start=start, despite_errors=page.despite_errors, **members)
        for members in bodies
    )

    def listening(link: str) -> None:
        click.echo(link)
        print_note("The page is open until you press Ctrl-C here.", style="dim")
        if not is_loopback(page.host):
            print_note(
                f"Other machines that reach {page.host} can open the page if they know this link, "
                "and read and change what you can here; the connection is not encrypted."
            )

    serve(
        body,
        own=own,
        others=others,
        host=page.host,
        port=page.port,
        browser=page.browser,
        listening=listening,
    )


def _content(
    name: str | None, page: Page
) -> "tuple[list[dict[str, Any]], dict[str, Any], Definitions | None]":
    """Return what the page knows of its bodies, with what it begins, and the user's definitions."""
    own = None
    if page.definitions is not None:
        from bodymeasure.chart import load_definitions

        own = load_definitions(page.definitions)
    chart = (
        page.chart
        if own is None
        else {None: None, EVERY: OWN}.get(page.chart, f"{OWN}:{page.chart}")
    )
    if page.report is None:
        return _bodies(name or DEFAULT_SAMPLE), {"start": {"chart": chart}}, own
    # Slow imports, which a page without a report does not need.
    from bodymeasure.chart import load_definitions
    from bodymeasure.cli.viewing import reported

    report = reported.finished(page.report)
    given = name or reported.atlas_of(report)
    wanted = reported.set_of(report, own or load_definitions())
    members = {**_bodies(given)[0]}
    reported.require_same(report, members["atlas"], given)
    members["differences"] = reported.differences_of(report, len(members["atlas"]))
    if wanted is None:
        return [members], {"start": {"chart": chart, "layers": ["diagonals"]}}, own
    definitions, preset = wanted
    if preset is None:
        return [members], {"start": {"chart": OWN if own else EVERY}}, own
    return [members], {"start": {"chart": f"{OWN}:{preset}"}}, definitions


def _bodies(name: str) -> list[dict[str, Any]]:
    """Return what the page knows of the bodies in a file, of which there may be many."""
    path = path_of_atlas(name)
    if path.suffix.lower() == ".npz" and path.is_file():
        bodies = read_population(path)
        if len(bodies) > 1:
            return [
                {
                    "atlas": body,
                    "name": body.name or f"{path.stem} {number}",
                    "file": f"{path.name}, body {number}",
                    "warnings": (_one_of_many(path, bodies, number), *check_sentences(body)),
                }
                for number, body in enumerate(bodies, start=1)
            ]
    loaded, members = loaded_body(name)
    return [{"atlas": loaded, "name": loaded.name or Path(name).stem, **members}]


def loaded_body(name: str) -> tuple["Atlas", dict[str, Any]]:
    """Return the atlas of a name, or the fit to a scan, and what the page knows of its file."""
    path = path_of_atlas(name)
    if is_scan(name):
        require_fit(page=False, pictures=False)
        fit = scan_subject(name, None)
        print_note(fitted_in_words(fit), style="dim")
        return fit.atlas, {"file": path.name, "warnings": (fitted_in_words(fit),)}
    atlas = load_atlas(name)
    members: dict[str, Any] = {"file": str(path), "warnings": check_sentences(atlas)}
    if name in sample_names() and path != Path(name):
        # A sample stays as it is.
        members["file"] = ""
    else:
        members["settings"] = file_settings()
    return atlas, members


def _one_of_many(path: Path, bodies: Sequence["Atlas"], number: int) -> str:
    return f"{path.name} holds {len(bodies)} bodies; this is number {number}."


def not_installed() -> InputError:
    """Return what a bare checkout is told, which has no viewer."""
    return InputError(
        "the viewer is part of an installed bodymeasure, and this is a bare checkout; "
        "install it with: pip install -e ."
    )
