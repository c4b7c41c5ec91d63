"""The report as one self-contained page."""

from collections.abc import Mapping
from typing import Protocol

from bodymeasure.report import numbers, templating
from bodymeasure.report.patches import views
from bodymeasure.report.patches.histogram import draw_histogram
from bodymeasure.report.patches.ranking import DISAGREEING, disagreements
from bodymeasure.report.patches.records import Document
from bodymeasure.report.templating import data_uri, images, moment, render_page
from bodymeasure.report.units import UNIT_NAMES


class Pictures(Protocol):
    """Pictures of a survey, as `bodymeasure.scene.pictures` returns them."""

    @property
    def body(self) -> Mapping[str, bytes]:
        """PNG of the body with all paths, by side: front, back, left, right."""

    @property
    def closeups(self) -> Mapping[int, bytes]:
        """PNG of a patch with its paths, by number of the patch."""

    @property
    def color_bar(self) -> bytes:
        """SVG of the key to the colors."""

    @property
    def note(self) -> str:
        """A remark on how they were drawn; may be empty."""


def render_html(
    document: Document, pictures: Pictures | None = None, *, scene: bytes | None = None
) -> bytes:
    """Return a document and its pictures as one HTML page that loads nothing else.

    Parameters
    ----------
    document : Document
    pictures : Pictures, optional
        Without them, the page has none.
    scene : bytes, optional
        A page that shows the body with its paths, to turn, which is put into this one.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    context = {
        "document": document,
        "summary": document.summary,
        "statuses": views.status_rows(document),
        "sentences": views.summary_sentences(document),
        "tiles": views.tiles(document),
        "regions": views.regions(document),
        "worst": views.worst_cases(document),
        "unmeasured": views.unmeasured(document),
        "findings": views.findings(document),
        "histogram": draw_histogram(document),
        "disagreeing": DISAGREEING,
        "disagreements": disagreements(document),
        "measured_codes": views.MEASURED,
        "has_check": views.has_check(document),
        "unit_name": UNIT_NAMES[document.unit],
        "created": moment(document.created),
        "body": {} if pictures is None else images(pictures.body),
        "closeups": {} if pictures is None else images(pictures.closeups),
        "color_bar": None if pictures is None else data_uri(pictures.color_bar),
        "picture_note": "" if pictures is None else pictures.note,
        "scene": templating.scene(scene),
        "text": numbers,
    }
    return render_page("bodymeasure.report", "report.html.j2", context)
