"""A chart of body measurements as one self-contained page."""

from collections.abc import Mapping
from typing import Protocol

from bodymeasure.report import templating
from bodymeasure.report.body import views
from bodymeasure.report.body.records import ChartDocument
from bodymeasure.report.body.tape import small_text
from bodymeasure.report.templating import images, moment, render_page
from bodymeasure.report.units import UNIT_NAMES


class TapePictures(Protocol):
    """Pictures of a chart's tapes, as `bodymeasure.scene.tape_pictures` returns them."""

    @property
    def body(self) -> Mapping[tuple[str, str], bytes]:
        """WebP or PNG of the body with a group's tapes, numbered, by group and side.

        Sides are front, back, left and right. Pictures are to be shown at half their size in
        pixels.
        """

    @property
    def closeups(self) -> Mapping[str, bytes]:
        """WebP or PNG of a tape from close by, by key of the measurement."""

    @property
    def numbers(self) -> Mapping[str, int]:
        """The numbers drawn, by key of the measurement."""

    @property
    def note(self) -> str:
        """A remark on how they were drawn; may be empty."""


def render_chart(
    document: ChartDocument, pictures: TapePictures | None = None, *, scene: bytes | None = None
) -> bytes:
    """Return a chart and its pictures as one HTML page that loads nothing else.

    Parameters
    ----------
    document : ChartDocument
    pictures : TapePictures, optional
        Without them, the page has none.
    scene : bytes, optional
        A page that shows the body with its tapes, to turn, which is put into this one.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    context = {
        "document": document,
        "groups": views.groups(document)
        if pictures is None
        else views.groups(document, pictures.numbers, images(pictures.body)),
        "tiles": views.tiles(document),
        "sentences": views.summary_sentences(document),
        "absences": views.absences(document),
        "gains": views.gains(document),
        "shifted": any(record.shifts for record in document.measurements),
        "remarked": views.remarked(document),
        "inches": document.unit == "inch",
        "unit_name": UNIT_NAMES[document.unit],
        "created": moment(document.created),
        "closeups": {} if pictures is None else images(pictures.closeups),
        "pictured": pictures is not None and bool(pictures.body),
        "picture_note": "" if pictures is None else pictures.note,
        "scene": templating.scene(scene),
        "text": {"small": small_text},
    }
    return render_page(
        "bodymeasure.report",
        "measurements.html.j2",
        context,
        feature="the page of measurements",
        styles=("measurements.css",),
    )
