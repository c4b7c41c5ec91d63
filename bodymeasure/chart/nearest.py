"""What a misspelled word was probably meant to be."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def hint(word: str, known: Iterable[str], *, expected: str = "expected one of") -> str:
    """The nearest known word as a question, or else all that are known."""
    known = list(known)
    near = difflib.get_close_matches(word, known, n=1)
    if near:
        return f"did you mean {near[0]!r}?"
    return f"{expected} {', '.join(known)}" if known else "there is none"
