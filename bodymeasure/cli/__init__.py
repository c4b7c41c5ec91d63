"""The command line: arguments in, calls, words out."""

from bodymeasure.cli.main import main

__all__ = ["main"]
