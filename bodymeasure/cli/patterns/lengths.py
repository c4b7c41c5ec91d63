"""Lengths with their units, as they are typed on the command line."""

import re

import click

METERS = {"mm": 0.001, "cm": 0.01, "m": 1.0, "in": 0.0254}


def eases(
    _ctx: click.Context, _parameter: click.Parameter, text: str | None
) -> dict[str, float] | None:
    """Return eases in meters by their levels, from a list such as ``bust=4cm,waist=2cm``.

    Raises
    ------
    click.BadParameter
        If it is no such list.
    """
    if text is None:
        return None
    result: dict[str, float] = {}
    for part in text.split(","):
        name, equals, length = (each.strip() for each in part.partition("="))
        number = re.fullmatch(r"([+-]?\d*\.?\d+)\s*(mm|cm|m|in)", length)
        if not name or not equals or number is None:
            raise click.BadParameter(
                f"{part.strip()!r} is no ease; expected levels with lengths, such as "
                "bust=4cm,waist=2cm (units: mm, cm, m, in)."
            )
        if name in result:
            raise click.BadParameter(f"{name!r} is given twice; give each level once.")
        result[name] = float(number[1]) * METERS[number[2]]
    return result
