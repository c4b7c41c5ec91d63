"""Reading and writing atlases; the format goes by the file's extension."""

from bodymeasure.formats.registry import (
    FORMATS,
    format_of,
    read_atlas,
    read_population,
    write_atlas,
    write_population,
)

__all__ = [
    "FORMATS",
    "format_of",
    "read_atlas",
    "read_population",
    "write_atlas",
    "write_population",
]
