"""The folder of a survey: its settings, the parts that are done, and the lock on it."""

from bodymeasure.surveys.folder.lock import locked
from bodymeasure.surveys.folder.parts import Parts
from bodymeasure.surveys.folder.settings import FILE, agree_on_settings, read_settings

__all__ = ["FILE", "Parts", "agree_on_settings", "locked", "read_settings"]
