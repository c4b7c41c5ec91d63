"""The types of arguments, checked where users call, with messages that say what was expected."""

import os
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TypeVar

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError

Kind = TypeVar("Kind")

# The most characters of a value that messages repeat.
SHOWN = 80


def shown(value: object) -> str:
    """Return a value as messages show it: its repr, shortened."""
    text = repr(value)
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}..."


def repeated(names: Iterable[str]) -> str | None:
    """Return the first name that stands more than once among some; None if all differ."""
    return next((name for name, count in Counter(names).items() if count > 1), None)


def file_path(value: object, name: str = "the path") -> Path:
    """Return the path of a file.

    Raises
    ------
    InputError
        If it is neither a text nor path-like.
    """
    try:
        text = os.fspath(value)  # type: ignore[call-overload]
    except TypeError:
        text = None
    if not isinstance(text, str):
        raise InputError(f"{name} is {shown(value)}; expected the name of a file")
    if "\0" in text:
        raise InputError(f"{name} is {shown(value)}; expected a name without null characters")
    return Path(text)


def require_kind(value: object, kind: type[Kind], name: str, expected: str) -> Kind:
    """Return a value of a type.

    Parameters
    ----------
    value : object
    kind : type
    name, expected : str
        What the message calls the value, and what it says was expected.

    Raises
    ------
    InputError
        If it is of another type.
    """
    if not isinstance(value, kind):
        raise InputError(f"{name} is {shown(value)}; expected {expected}")
    return value


def require_members(value: object, names: tuple[str, ...], name: str, expected: str) -> None:
    """Raise an InputError unless a value has some attributes, whatever its type."""
    if not all(hasattr(value, each) for each in names):
        raise InputError(f"{name} is {shown(value)}; expected {expected}")


def several(values: object, kind: type[Kind], name: str, expected: str) -> tuple[Kind, ...]:
    """Return values of a type as a tuple.

    Raises
    ------
    InputError
        If they are not several, or one is of another type; a single text is not several.
    """
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise InputError(f"{name} is {shown(values)}; expected several of them, as in a list")
    return tuple(
        require_kind(value, kind, f"{name}, item {number},", expected)
        for number, value in enumerate(values)
    )


def require_progress(progress: object) -> None:
    """Raise an InputError unless progress is reported to a function, or not at all."""
    if progress is not None and not isinstance(progress, Callable):  # type: ignore[arg-type]
        raise InputError(f"progress is {shown(progress)}; expected a function, or None")


def numbers(value: object, name: str, expected: str) -> Array:
    """Return an array of numbers.

    Raises
    ------
    InputError
        If the value is none.
    """
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {shown(value)}; expected {expected}") from None


def whole_numbers(value: object, name: str, expected: str) -> Ints:
    """Return an array of whole numbers, as faces are of the numbers of their vertices.

    Raises
    ------
    InputError
        If the value is none, as lists of different lengths are.
    """
    try:
        array = np.asarray(value)
    except ValueError:
        array = np.empty(0)
    if array.dtype.kind not in "iu":
        raise InputError(f"{name} is {shown(value)}; expected {expected}")
    return array.astype(np.int64)
