"""Words that messages share: what a misspelled word was meant to be, and numbers with nouns."""

import difflib
from collections.abc import Iterable


def nearest(word: str, known: Iterable[str], *, similarity: float = 0.6) -> str | None:
    """The known word that is most like a misspelled one, if any is similar enough."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=similarity)
    return near[0] if near else None


def hint(word: str, known: Iterable[str], *, expected: str = "expected one of") -> str:
    """The nearest known word as a question, or else all that are known."""
    known = list(known)
    near = nearest(word, known)
    if near is not None:
        return f"did you mean {near!r}?"
    return f"{expected} {', '.join(known)}" if known else "there is none"


def counted(number: int, singular: str, plural: str | None = None) -> str:
    """A number with its noun."""
    return f"{number:,} {singular if number == 1 else plural or singular + 's'}"
