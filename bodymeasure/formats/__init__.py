"""Reading and writing atlases; the format goes by the file's extension."""

from bodymeasure.formats.registry import read_atlas, write_atlas

__all__ = ["read_atlas", "write_atlas"]
