"""The arguments and options that are measurements."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from bodymeasure.errors import InputError

if TYPE_CHECKING:
    from bodymeasure.chart import Definitions
    from bodymeasure.make import Measurements

values_argument = click.argument("measurements", metavar="MEASUREMENTS...", nargs=-1, required=True)


def _changes(
    _ctx: click.Context, _parameter: click.Parameter, given: tuple[str, ...]
) -> dict[str, list[str]] | None:
    found: dict[str, list[str]] = {}
    for text in given:
        key, equals, changes = text.partition("=")
        if not equals or not key.strip() or not changes.strip():
            raise InputError(
                f"--vary: {text!r} is no change; expected such as bust_girth=+4cm,+8cm"
            )
        if key.strip() in found:
            raise InputError(f"--vary: {key.strip()!r} is given twice; list its changes once")
        found[key.strip()] = [change.strip() for change in changes.split(",")]
    return found or None


vary_option = click.option(
    "--vary",
    multiple=True,
    callback=_changes,
    metavar="KEY=CHANGES",
    help="Make further bodies with a measurement changed, such as bust_girth=+4cm,+8cm; given "
    "several times, measurements are changed together.",
)


def given_values(
    texts: tuple[str, ...], definitions: "Definitions", unit: str | None, only: tuple[str, ...]
) -> "tuple[Measurements, ...]":
    """Return the measurements of a file, or those that were given one by one.

    Raises
    ------
    InputError
        If there are both, several files, or something is wrong with them.
    """
    from bodymeasure.make import Measurements, read_measurements
    from bodymeasure.make.input.json_files import value_of
    from bodymeasure.make.input.names import Names

    single = [text for text in texts if "=" in text and not Path(text).exists()]
    if not single:
        if len(texts) > 1:
            raise click.UsageError(
                "MEASUREMENTS is one file; write several people into one CSV file, with a column "
                "subject or one row for each."
            )
        return read_measurements(texts[0], definitions=definitions, unit=unit, only=only)
    if len(single) < len(texts):
        other = next(text for text in texts if text not in single)
        raise click.UsageError(f"{other!r} is not KEY=VALUE; give either a file or values.")
    if only:
        raise click.UsageError("--only chooses from a file; leave out values that you do not want.")
    names, found = Names(definitions), {}
    for text in single:
        name, _, value = text.partition("=")
        key = names.find(name, text)
        if key in found:
            raise InputError(f"{text}: {key!r} is given a second time; keep one")
        found[key] = value_of(key, value, unit, text, names)
    return (Measurements("made", tuple(found.values())),)
