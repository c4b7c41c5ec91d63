"""shapely, which computes with areas in the plane, loaded when it is first asked for.

Whoever unfolds single patches, or uses another part of bodymeasure, does without it.
"""

from importlib import import_module
from typing import Any

from bodymeasure.errors import MissingExtraError


class _Shapely:
    """Stands for the module."""

    def __getattr__(self, name: str) -> Any:
        try:
            return getattr(import_module("shapely"), name)
        except ModuleNotFoundError:
            feature = "cutting pieces out of the skin"
            raise MissingExtraError(feature, "shapely", "pattern") from None


shapely = _Shapely()
