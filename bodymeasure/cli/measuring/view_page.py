"""`bodymeasure view`: the page in the browser."""

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from bodymeasure.atlas import Severity, check_atlas
from bodymeasure.cli.console import print_note
from bodymeasure.cli.fitting.files import fitted_in_words
from bodymeasure.cli.fitting.scans import is_scan, require_fit, scan_subject
from bodymeasure.cli.options import file_settings, load_atlas, path_of_atlas, require
from bodymeasure.errors import InputError
from bodymeasure.samples import sample_names
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas

SERVER = (
    ("the page", "starlette", "starlette", "viewer"),
    ("the page", "uvicorn", "uvicorn", "viewer"),
)
# The key under which the page knows a file of definitions.
OWN, EVERY = "own", "default"
# Findings that are told; `bodymeasure check` lists all.
TOLD = 3


class Page(NamedTuple):
    """What the page begins with, and where it is served.

    Parameters
    ----------
    chart : str or None
        The set of measurements that is shown at once.
    definitions : Path or None
        A file of definitions.
    host : str
    port : int
    browser : bool
    """

    chart: str | None
    definitions: Path | None
    host: str
    port: int
    browser: bool


def show_page(name: str, page: Page) -> None:
    """Serve the page of a body until it is interrupted.

    Parameters
    ----------
    name : str
        The name of a file or a sample that the command was given.
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
    own = None
    if page.definitions is not None:
        from bodymeasure.chart import load_definitions

        own = load_definitions(page.definitions)
    loaded, members = loaded_body(name)
    chart = OWN if own is not None and page.chart == EVERY else page.chart
    body = ShownBody(
        id="0",
        atlas=loaded,
        name=loaded.name or Path(name).stem,
        start={"start": {"chart": chart}},
        **members,
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
        host=page.host,
        port=page.port,
        browser=page.browser,
        listening=listening,
    )


def loaded_body(name: str) -> tuple["Atlas", dict[str, Any]]:
    """Return the atlas of a name, or the fit to a scan, and what the page knows of its file."""
    path = path_of_atlas(name)
    if is_scan(name):
        require_fit(page=False, pictures=False)
        fit = scan_subject(name, None)
        print_note(fitted_in_words(fit), style="dim")
        return fit.atlas, {"file": path.name, "warnings": (fitted_in_words(fit),)}
    atlas = load_atlas(name)
    members: dict[str, Any] = {"file": str(path), "warnings": _findings(atlas)}
    if name in sample_names() and path != Path(name):
        # A sample stays as it is.
        members["file"] = ""
    else:
        members["settings"] = file_settings()
    return atlas, members


def _findings(atlas: "Atlas") -> tuple[str, ...]:
    """Return what is wrong with an atlas, which can be looked at all the same."""
    errors = [found for found in check_atlas(atlas) if found.severity == Severity.ERROR]
    if not errors:
        return ()
    told = "; ".join(found.message for found in errors[:TOLD])
    return (
        f"The check of the atlas finds {counted(len(errors), 'error')}, near which lengths may "
        f"be wrong: {told}{'; …' if len(errors) > TOLD else ''}",
    )


def not_installed() -> InputError:
    """Return what a bare checkout is told, which has no viewer."""
    return InputError(
        "the viewer is part of an installed bodymeasure, and this is a bare checkout; "
        "install it with: pip install -e ."
    )
