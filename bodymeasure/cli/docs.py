"""`bodymeasure docs`: the documentation that comes with the package."""

import shutil
import tempfile
from pathlib import Path

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_note, print_table
from bodymeasure.cli.tables import new_table
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

FOLDER = Path(__file__).parents[1] / "docs"
# In the order in which a newcomer reads them.
PAGES = (
    "quickstart",
    "charts",
    "patterns",
    "viewer",
    "landmarks",
    "scans",
    "made_bodies",
    "body_models",
    "surveys",
    "python",
    "pyvista",
    "api",
    "formats",
    "atlas_format",
    "method",
    "analysis",
    "proofs",
    "accuracy",
    "paper",
    "paper_tables",
    "architecture",
)
HTML = """<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>{title}</title>
<style>
body {{ max-width: 50rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.5 sans-serif; }}
pre {{ background: #f4f4f4; padding: 0.7rem; overflow-x: auto; }}
table {{ border-collapse: collapse; }} td, th {{ border: 1px solid #ccc; padding: 0.2rem 0.5rem; }}
img {{ max-width: 100%; }}
</style>
{body}
</html>
"""


@click.command(epilog=EXIT_CODES)
@click.argument("page", required=False)
@click.option("--open", "opens", is_flag=True, help="Open the page in the web browser.")
def docs(page: str | None, opens: bool) -> None:
    """Print a PAGE of the documentation, or open it in the web browser.

    Without PAGE, list the pages; with --open, begin with the first.
    """
    if page is not None and page not in PAGES:
        raise InputError(f"no page is named {page!r}; {hint(page, PAGES)}")
    if opens:
        index = _as_html(Path(tempfile.mkdtemp(prefix="bodymeasure-docs-")), page or PAGES[0])
        print_note(f"Opening {index}", style="")
        click.launch(str(index))
    elif page is None:
        table = new_table("page", "title", words=("title",))
        for name in PAGES:
            table.add_row(Text(name, "bold"), Text(_title(_text(name))))
        print_table(table)
    elif RESULTS.is_terminal:
        # Slow to load, and not needed where the text goes into a pipe.
        from rich.markdown import Markdown

        RESULTS.print(Markdown(_text(page)))
    else:
        click.echo(_text(page), nl=False)


def _text(page: str) -> str:
    """Return the Markdown of a page."""
    return (FOLDER / f"{page}.md").read_text(encoding="utf-8")


def _title(text: str) -> str:
    """Return the title of a page, which is its first line."""
    return text.partition("\n")[0].removeprefix("# ")


def _as_html(folder: Path, page: str) -> Path:
    """Write all pages as HTML, so that their links work, and return the file of one of them."""
    from markdown_it import MarkdownIt

    reader = MarkdownIt("commonmark").enable("table")
    for name in PAGES:
        text = _text(name)
        body = reader.render(text)
        for other in PAGES:
            body = body.replace(f'href="{other}.md', f'href="{other}.html')
        html = HTML.format(title=_title(text), body=body)
        (folder / f"{name}.html").write_text(html, encoding="utf-8")
    for picture in FOLDER.glob("*.svg"):
        shutil.copy(picture, folder)
    return folder / f"{page}.html"
