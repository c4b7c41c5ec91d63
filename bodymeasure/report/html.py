"""The report as one self-contained page."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from datetime import datetime
from importlib.resources import files
from typing import Any, Protocol, TypeVar

from bodymeasure.errors import MissingExtraError
from bodymeasure.report import numbers, views
from bodymeasure.report.chart import chart
from bodymeasure.report.ranking import DISAGREEING, disagreements
from bodymeasure.report.records import Document

Key = TypeVar("Key")


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
        """SVG of what the colors mean."""

    @property
    def note(self) -> str:
        """What there is to say about how they were drawn; may be empty."""


def render_html(document: Document, pictures: Pictures | None = None) -> bytes:
    """A document and its pictures as one HTML page that loads nothing else.

    Parameters
    ----------
    document : Document
    pictures : Pictures, optional
        The page has none if not given.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    try:
        import jinja2
    except ImportError:
        raise MissingExtraError("the HTML report", "jinja2", "report") from None
    templates = files("bodymeasure.report").joinpath("templates")
    environment = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["scientific"] = numbers.scientific
    environment.filters["percent"] = numbers.percent
    environment.filters["unbroken"] = numbers.unbroken
    environment.filters["with_code"] = numbers.with_code
    template = environment.from_string(templates.joinpath("report.html.j2").read_text("utf-8"))
    css = templates.joinpath("report.css").read_text("utf-8")
    return template.render(**_context(document, pictures), css=css).encode()


def _context(document: Document, pictures: Pictures | None) -> dict[str, Any]:
    return {
        "document": document,
        "summary": document.summary,
        "statuses": views.status_rows(document),
        "sentences": views.summary_sentences(document),
        "tiles": views.tiles(document),
        "regions": views.regions(document),
        "worst": views.worst_cases(document),
        "unmeasured": views.unmeasured(document),
        "findings": views.findings(document),
        "chart": chart(document),
        "disagreeing": DISAGREEING,
        "disagreements": disagreements(document),
        "measured_codes": views.MEASURED,
        "has_check": views.has_check(document),
        "unit_name": views.UNIT_NAMES[document.unit],
        "created": _moment(document.created),
        "body": {} if pictures is None else _images(pictures.body),
        "closeups": {} if pictures is None else _images(pictures.closeups),
        "color_bar": None if pictures is None else data_uri(pictures.color_bar),
        "picture_note": "" if pictures is None else pictures.note,
        "text": numbers,
    }


def _moment(created: str) -> str:
    moment = datetime.fromisoformat(created)
    return f"{moment:%Y-%m-%d %H:%M} {moment.tzname() or ''}".strip()


def data_uri(content: bytes) -> str:
    """A PNG or SVG picture as the value of an ``src`` attribute."""
    kind = "image/png" if content.startswith(b"\x89PNG") else "image/svg+xml"
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def _images(pictures: Mapping[Key, bytes]) -> dict[Key, dict[str, Any]]:
    images = {}
    for key, content in pictures.items():
        # The header chunk of a PNG comes first: width and height as big-endian words.
        width, height = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))
        images[key] = {"uri": data_uri(content), "width": width, "height": height}
    return images
