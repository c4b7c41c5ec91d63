"""The page `bodymeasure/docs/api.md`, made from the public names and their docstrings.

Write it anew after a change of a public docstring: ``python tests/helpers/api_page.py``.
`tests/test_docs.py` says when the page is old.
"""

import enum
import inspect
import re
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path

import bodymeasure as bm

PAGE = Path(bm.__file__).parent / "docs" / "api.md"
HEAD = """# API

All public names, by subject; `import bodymeasure as bm` has them at the top. `python
tests/helpers/api_page.py` makes this page from the docstrings.
"""
# The subjects, each with the packages that hold its names.
SUBJECTS = {
    "Bodies, files and samples": ("atlas", "formats", "samples", "bezier"),
    "Bodies from scans": ("fit",),
    "Geodesics": ("geodesic",),
    "Girths, tapes and other measurements": ("measure", "section", "taut"),
    "Charts of body measurements": ("chart",),
    "Bodies made to measure": ("make",),
    "Surveys of many bodies": ("surveys",),
    "Flat pieces": ("pattern", "report.patterns"),
    "Reports": ("report",),
    "Looking at bodies": ("viewer",),
    "Meshes": ("mesh",),
    "Errors": ("errors",),
}
# Sections of a docstring that list things with their types.
LISTS = {"Parameters", "Returns", "Raises", "Attributes", "Yields"}
SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}\n", flags=re.MULTILINE)


def page() -> str:
    """Return the text of the page."""
    parts = [HEAD]
    left = list(bm.__all__)
    for subject, homes in SUBJECTS.items():
        modules = [import_module(f"bodymeasure.{home}") for home in homes]
        names = [name for name in left if any(hasattr(module, name) for module in modules)]
        left = [name for name in left if name not in names]
        parts.append(f"## {subject}\n")
        # Functions first: they are what a reader looks for.
        for name in sorted(names, key=lambda name: (not name.islower(), name.lower())):
            parts += _entry(name, getattr(bm, name))
    if left:
        raise ValueError(f"no subject holds {', '.join(left)}")
    return "\n".join(parts)


def _entry(name: str, member: object) -> Iterator[str]:
    """Yield the parts of the page for one name."""
    if not (inspect.isclass(member) or inspect.isroutine(member)):
        yield f"### `{name}`\n"
        kind = "A union of types" if not isinstance(member, bm.Kernel) else "A kernel"
        yield f"{kind}: `{re.sub(r'[a-z_.]+[.](?=[A-Z])', '', str(member))}`.\n"
        return
    yield f"### `{name}{_signature(member)}`\n"
    yield from _docstring(inspect.getdoc(member) or "")
    if inspect.isclass(member) and issubclass(member, enum.Enum):
        yield "".join(f"- `{each.name}`: {each.value}\n" for each in member)
    elif inspect.isclass(member):
        yield from _members(member)


def _signature(member: object) -> str:
    """Return the parameters with their defaults; their types are in the docstring."""
    if inspect.isclass(member) and issubclass(member, (enum.Enum, Exception)):
        return ""
    if getattr(member, "_is_protocol", False):
        return ""
    try:
        signature = inspect.signature(member)  # type: ignore[arg-type]
    except ValueError:
        return ""
    bare = []
    for each in signature.parameters.values():
        default = each.default
        if isinstance(default, enum.Enum):
            default = _Shown(repr(str(default)))
        elif default is not each.empty and not isinstance(default, (int, float, str, tuple)):
            default = _Shown(getattr(default, "__name__", "None" if default is None else "..."))
        bare.append(each.replace(annotation=each.empty, default=default))
    return str(signature.replace(parameters=bare, return_annotation=signature.empty))


class _Shown:
    """A default value with a short name."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __repr__(self) -> str:
        return self.name


def _docstring(text: str) -> Iterator[str]:
    """Yield a numpydoc docstring's sections in Markdown."""
    summary, *sections = SECTION.split(text)
    yield summary.rstrip() + "\n"
    for title, body in zip(sections[::2], sections[1::2], strict=True):
        yield f"**{title}**\n"
        if title == "Examples":
            yield f"```python\n{body.rstrip()}\n```\n"
        elif title in LISTS:
            yield "".join(_items(body))
        else:
            yield body.rstrip() + "\n"


def _items(body: str) -> Iterator[str]:
    """Yield the items of a section of parameters and the like, as a Markdown list."""
    for item in re.split(r"\n(?=\S)", body.strip("\n")):
        head, *rest = item.splitlines()
        name, colon, kind = head.partition(" : ")
        words = " ".join(line.strip() for line in rest)
        yield f"- `{name}`{f', {kind}' if colon else ''}{': ' + words if words else ''}\n"


def _members(member: type) -> Iterator[str]:
    """Yield the methods and properties of a class, each with its first line."""
    lines = []
    for name, each in vars(member).items():
        held = each.__func__ if isinstance(each, (classmethod, staticmethod)) else each
        words = (inspect.getdoc(held) or "").partition("\n")[0]
        if name.startswith("_") or not words:
            continue
        if isinstance(each, property | cached_property):
            lines.append(f"- `.{name}`: {words}\n")
        elif inspect.isfunction(held):
            lines.append(
                f"- `.{name}({', '.join(list(inspect.signature(held).parameters)[1:])})`: {words}\n"
            )
    if lines:
        yield "**Methods and properties**\n"
        yield "".join(lines)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
