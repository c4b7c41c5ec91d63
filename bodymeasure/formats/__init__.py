"""Reading and writing atlases; the file's extension decides the format."""

from bodymeasure.formats.registry import (
    EXTENSIONS,
    FORMATS,
    format_of,
    read_atlas,
    read_population,
    write_atlas,
    write_population,
)

__all__ = [
    "EXTENSIONS",
    "FORMATS",
    "format_of",
    "read_atlas",
    "read_population",
    "write_atlas",
    "write_population",
]
