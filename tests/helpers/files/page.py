"""A strict parser of the pages that the package writes."""

import base64
import gzip
import re
from html.parser import HTMLParser

VOID = {"meta", "img", "br", "link", "input", "hr"}


class Page(HTMLParser):
    """Parse a page strictly: every element that needs an end tag must have it, in order."""

    def __init__(self, content: bytes) -> None:
        super().__init__(convert_charrefs=True)
        self.source = content.decode()
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.feed(self.source)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), f"<{tag}> repeats an attribute"
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if not {"style", "title", "script"} & set(self.open):
            self.words.append(data)

    @property
    def text(self) -> str:
        return re.sub(r"[\s\u00a0]+", " ", "".join(self.words))

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]

    def check_links(self) -> None:
        """Check that identifiers are unique, and that every reference leads to one."""
        identifiers = [a["id"] for _, a in self.elements if "id" in a]
        assert len(identifiers) == len(set(identifiers))
        targets = [(a["href"] or "").removeprefix("#") for a in self.all("a")]
        assert targets
        assert set(targets) <= set(identifiers)
        referred = [a["aria-labelledby"] for _, a in self.elements if "aria-labelledby" in a]
        assert set(referred) <= set(identifiers)
        scopes = {header.get("scope") for header in self.all("th")}
        assert scopes <= {"col", "row", "colgroup", "rowgroup"}

    @property
    def scene(self) -> bytes:
        """The page that this page carries, to be opened in its frame."""
        text = self.source.split('id="scene-page">')[1].split("</script>")[0]
        return gzip.decompress(base64.b64decode(text, validate=True))

    def check_self_contained(self, *, scene: bool = False) -> None:
        """Check that nothing is loaded from elsewhere; a scene has a frame and scripts in place."""
        own = {"script", "iframe"} if scene else set()
        for tag, attributes in self.elements:
            assert tag not in {"link", "script", "iframe", "object", "base"} - own
            for name in ("src", "href", "srcset", "data", "action", "poster"):
                value = attributes.get(name)
                assert value is None or value.startswith(("data:image/", "#")), (tag, name)
        style = self.source.split("<style>")[1].split("</style>")[0]
        assert "url(" not in style
        assert "@import" not in style
