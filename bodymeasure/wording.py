"""Words that messages share: hints for misspelled words, numbers with nouns, lines for results."""

import difflib
from collections.abc import Iterable

# The number of known words that a message lists at most.
LISTED = 50


def nearest(word: str, known: Iterable[str], *, similarity: float = 0.6) -> str | None:
    """Return the known word that is most like a misspelled one, if any is similar enough."""
    # What is given in place of a word, such as None, is like none.
    near = difflib.get_close_matches(str(word), list(known), n=1, cutoff=similarity)
    return near[0] if near else None


def hint(word: str, known: Iterable[str], *, expected: str = "expected one of") -> str:
    """Return the nearest known word as a question, or else the words that are known."""
    known = list(known)
    near = nearest(word, known)
    if near is not None:
        return f"did you mean {near!r}?"
    more = f", and {len(known) - LISTED} more" if len(known) > LISTED else ""
    return f"{expected} {', '.join(known[:LISTED])}{more}" if known else "there are none"


def counted(number: int, singular: str, plural: str | None = None) -> str:
    """Return a number with its noun."""
    return f"{number:,} {singular if number == 1 else plural or singular + 's'}"


def result_line(
    kind: str, unit: str | None, error: float, *, outcome: str = "", **values: float
) -> str:
    """Return the line that stands for a result: its values, their error and the outcome."""
    ending = f" {unit}" if unit else ""
    parts = [f"{name} {value:.6g}{ending}" for name, value in values.items()]
    parts.append(f"error {error:.1g}{ending}")
    return f"<{kind} of {', '.join([*parts, outcome] if outcome else parts)}>"
