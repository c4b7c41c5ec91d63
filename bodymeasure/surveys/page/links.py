"""Links from a page to bodies: to their files, or to atlases that are written beside the page."""

from collections.abc import Iterable
from pathlib import Path
from urllib.parse import quote

from bodymeasure.errors import BodymeasureError
from bodymeasure.formats import write_atlas
from bodymeasure.surveys.bodies.again import BodiesAgain
from bodymeasure.surveys.bodies.files import seen_from
from bodymeasure.surveys.folder import FILE, read_settings
from bodymeasure.surveys.records import SurveyTable

BODIES = "bodies"


def settings_beside(table: SurveyTable) -> dict[str, object]:
    """Return what the user said about the files of a survey; nothing if its settings are gone."""
    path = table.path.parent / FILE
    if not path.is_file():
        return {}
    bodies = read_settings(path).get("bodies")
    found = bodies.get("settings") if isinstance(bodies, dict) else None
    return found if isinstance(found, dict) else {}


def body_links(table: SurveyTable, bodies: Iterable[int], folder: Path) -> dict[int, str]:
    """Return the address of each of some bodies, from a folder; those of files of many are written.

    A body that cannot be read any more has none.

    Parameters
    ----------
    table : SurveyTable
    bodies : iterable of int
    folder : Path
        Of the page.
    """
    home = table.path.parent.resolve()
    again = BodiesAgain(home, settings_beside(table))
    found = {}
    for body in sorted(bodies):
        name, source = table.subjects[body], table.sources[body]
        if source and (home / source).is_file():
            found[body] = quote(seen_from((home / source).resolve(), folder.resolve()))
            continue
        path = folder / BODIES / f"body-{body + 1:07}.atlas"
        try:
            if not path.is_file():
                atlas = again.atlas(name, source)
                path.parent.mkdir(exist_ok=True)
                write_atlas(atlas, path)
        except (BodymeasureError, OSError):
            continue
        found[body] = f"{BODIES}/{path.name}"
    return found
