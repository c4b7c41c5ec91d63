"""Pages from templates: each page is one file that loads nothing else."""

import base64
import gzip
import struct
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from importlib.resources import files
from typing import Any, TypedDict, TypeVar

from bodymeasure.errors import MissingExtraError
from bodymeasure.report import numbers
from bodymeasure.wording import counted

# Higher levels of compression take four times as long for a fiftieth of the size.
LEVEL = 6

Key = TypeVar("Key")

FILTERS: Mapping[str, Callable[..., object]] = {
    "scientific": numbers.scientific,
    "percent": numbers.percent,
    "unbroken": numbers.unbroken,
    "with_code": numbers.with_code,
}


def render_page(
    package: str,
    template: str,
    context: Mapping[str, Any],
    *,
    feature: str = "the HTML report",
    filters: Mapping[str, Callable[..., object]] | None = None,
    styles: Sequence[str] = (),
) -> bytes:
    """Return a page: a template that is filled in, with names and words escaped.

    Parameters
    ----------
    package : str
        The package whose folder ``templates`` holds the template.
    template : str
        Name of its file.
    context : mapping of str to object
        The names that the template uses; ``css`` is added.
    feature : str
        A name for the page, for the message if jinja2 is missing.
    filters : mapping of str to function, optional
        Filters besides `FILTERS`.
    styles : sequence of str
        Style sheets of `bodymeasure.report` that follow ``report.css``.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    try:
        import jinja2
    except ImportError:
        raise MissingExtraError(feature, "jinja2", "report") from None
    environment = jinja2.Environment(
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        # Finds the macros that several pages share.
        loader=jinja2.FunctionLoader(lambda name: _text("bodymeasure.report", name)),
    )
    environment.filters.update({**FILTERS, **(filters or {})})
    environment.globals["counted"] = counted
    css = [_text("bodymeasure.report", name) for name in ("report.css", *styles)]
    page = environment.from_string(_text(package, template))
    return page.render(**context, css="\n".join(css)).encode()


def _text(package: str, name: str) -> str:
    return files(package).joinpath("templates", name).read_text("utf-8")


def moment(created: str) -> str:
    """Return a time in ISO 8601 as people read it."""
    when = datetime.fromisoformat(created)
    return f"{when:%Y-%m-%d %H:%M} {when.tzname() or ''}".strip()


def data_uri(content: bytes) -> str:
    """Return a PNG, WebP or SVG picture as the value of an ``src`` attribute."""
    starts = {b"\x89PNG": "png", b"RIFF": "webp"}
    kind = starts.get(content[:4], "svg+xml")
    return f"data:image/{kind};base64,{base64.b64encode(content).decode()}"


class Scene(TypedDict):
    """A page of its own inside a page: its text, packed, and the script that opens it."""

    page: str
    script: str


def scene(page: bytes | None) -> Scene | None:
    """Return a page that is to stand inside another one; None for None."""
    if page is None:
        return None
    # Without the time, so that the same page is the same file.
    packed = base64.b64encode(gzip.compress(page, LEVEL, mtime=0)).decode()
    return {"page": packed, "script": _text("bodymeasure.report", "scene.js")}


class Image(TypedDict):
    """A picture for a page, and its size in pixels."""

    uri: str
    width: int
    height: int


def images(pictures: Mapping[Key, bytes]) -> dict[Key, Image]:
    """Return PNG or WebP pictures by key, each with its address, width and height."""
    found: dict[Key, Image] = {}
    for key, content in pictures.items():
        width, height = _size(content)
        found[key] = {"uri": data_uri(content), "width": width, "height": height}
    return found


def _size(content: bytes) -> tuple[int, int]:
    """Return the width and height that the head of a picture states."""
    if content.startswith(b"RIFF"):
        # The frame of a lossy WebP holds them in 14 bits each, little-endian.
        width, height = struct.unpack_from("<HH", content, 26)
        return width & 0x3FFF, height & 0x3FFF
    # The header, which comes first in a PNG, holds them as big-endian words.
    width, height = struct.unpack_from(">II", content, 16)
    return width, height
