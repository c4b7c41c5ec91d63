"""Views of a measured body.

Each name is loaded when it is first asked for, so that nobody pays for a window who wants a page.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bodymeasure.viewer.page.export import export_page
    from bodymeasure.viewer.page.notebook import show
    from bodymeasure.viewer.window.describe import describe, describe_measured
    from bodymeasure.viewer.window.show import view, view_chart

__all__ = ["describe", "describe_measured", "export_page", "show", "view", "view_chart"]

_MODULES = {
    "describe": "window.describe",
    "describe_measured": "window.describe",
    "export_page": "page.export",
    "show": "page.notebook",
    "view": "window.show",
    "view_chart": "window.show",
}


def __getattr__(name: str) -> object:
    """Load a public name."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
