"""Pages from templates: each page is one file that loads nothing else."""

import base64
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from importlib.resources import files
from typing import Any, TypedDict, TypeVar

from bodymeasure.errors import MissingExtraError
from bodymeasure.report import numbers
from bodymeasure.wording import counted

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
    """Return a PNG or SVG picture as the value of an ``src`` attribute."""
    kind = "image/png" if content.startswith(b"\x89PNG") else "image/svg+xml"
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


class Image(TypedDict):
    """A picture for a page, and its size in pixels."""

    uri: str
    width: int
    height: int


def images(pictures: Mapping[Key, bytes]) -> dict[Key, Image]:
    """Return PNG pictures by key, each with its address, width and height."""
    found: dict[Key, Image] = {}
    for key, content in pictures.items():
        # The header, which comes first in a PNG, holds width and height as big-endian words.
        width, height = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))
        found[key] = {"uri": data_uri(content), "width": width, "height": height}
    return found
