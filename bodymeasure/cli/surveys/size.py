"""Sizes as the command line is given them: keys of measurements with values."""

from collections.abc import Callable
from typing import Any, TypeVar

import click

_Command = TypeVar("_Command", bound=Callable[..., Any])


def pairs(text: str) -> dict[str, float]:
    """Return the numbers of a list such as ``stature=168,waist_girth=72``, by their keys.

    Raises
    ------
    click.BadParameter
        If it is no such list.
    """
    found: dict[str, float] = {}
    for part in text.split(","):
        key, sign, number = (each.strip() for each in part.partition("="))
        try:
            value = float(number)
        except ValueError:
            value = 0.0
        if not (key and sign and 0.0 < value < float("inf")) or key in found:
            raise click.BadParameter(
                f"{part.strip()!r} is no measurement with a number above zero; expected keys with "
                "numbers, each once, such as stature=168,waist_girth=72."
            )
        found[key] = value
    return found


def size_option(command: _Command) -> _Command:
    """Add the option for sizes that bodies are looked for near to."""
    return click.option(
        "--size",
        "sizes",
        metavar="KEY=VALUE,...",
        multiple=True,
        callback=lambda _ctx, _parameter, values: tuple(map(pairs, values)),
        help="Name the bodies nearest to this size on the page, in the unit of the lengths; may be "
        "given several times.",
    )(command)
