"""`bodymeasure landmarks list`."""

from __future__ import annotations

import csv
import io
import json
from typing import TYPE_CHECKING, Any

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.options import (
    EXIT_CODES,
    atlas_argument,
    despite_errors_option,
    load_sound_atlas,
    unit_option,
)

if TYPE_CHECKING:
    from bodymeasure.chart.derive import Derived
    from bodymeasure.chart.needed import Lacking

# Decimals of positions in the table: to a tenth of a millimeter or finer.
DECIMALS = {"m": 4, "cm": 2, "mm": 1, "inch": 3}
PARAMETER_DECIMALS = 4
OWN = "picked"
COLUMNS = ("name", "patch", "u", "v", "x", "y", "z", "origin", "remark")

format_option = click.option(
    "--format",
    "form",
    type=click.Choice(["table", "csv", "json"]),
    default="table",
    show_default=True,
    help="How to print; csv and json have all digits.",
)


@click.command(
    "list", short_help="List landmarks, and which are missing (the default).", epilog=EXIT_CODES
)
@atlas_argument
@format_option
@unit_option
@despite_errors_option
def list_landmarks(atlas: str, form: str, unit: str, despite_errors: bool) -> None:
    """List the landmarks of ATLAS: those that were picked, and those that follow by rule.

    Then those that no rule could give, why, and which measurements lack them.
    """
    # Not needed by `--help` and the like, and slow to load.
    from bodymeasure.chart.derive import derive_landmarks
    from bodymeasure.chart.needed import lacking

    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    derived = derive_landmarks(loaded, ())
    lacks = lacking((), derived.landmarks)
    rows = _rows(loaded, derived, Unit.parse(unit))
    if form == "json":
        click.echo(_json(loaded.name or atlas, unit, rows, derived, lacks).encode(), nl=False)
    elif form == "csv":
        click.echo(csv_text(COLUMNS, rows).encode(), nl=False)
    else:
        _print(rows, derived, lacks, unit)


def csv_text(columns: tuple[str, ...], rows: list[dict[str, Any]]) -> str:
    """Rows as CSV (RFC 4180) with a header; every float round-trips."""
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, columns, restval="", lineterminator="\r\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def json_text(content: dict[str, Any]) -> str:
    """A document as JSON; its lists hold one item a line."""
    members = []
    for key, value in content.items():
        text = json.dumps(value, ensure_ascii=False)
        if isinstance(value, list) and value:
            items = ",\n".join(json.dumps(item, ensure_ascii=False) for item in value)
            text = f"[\n{items}\n]"
        members.append(f"{json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(members) + "\n}\n"


def _rows(atlas: Atlas, derived: Derived, unit: Unit) -> list[dict[str, Any]]:
    from bodymeasure.chart.rule_words import rule_words

    scale = atlas.unit.metres / unit.metres
    rows: list[dict[str, Any]] = []
    for name, point in derived.landmarks.items():
        x, y, z = (scale * atlas.position(point)).tolist()
        by_rule = name in derived.rules
        rows.append(
            {
                "name": name,
                "patch": atlas.patch_names[point.patch],
                "u": point.u,
                "v": point.v,
                "x": x,
                "y": y,
                "z": z,
                "origin": "rule" if by_rule else OWN,
                "remark": rule_words(derived.rules[name]) if by_rule else "",
            }
        )
    for name, reason in derived.missing.items():
        rows.append({"name": name, "origin": "missing", "remark": reason})
    return rows


def _json(
    name: str,
    unit: str,
    rows: list[dict[str, Any]],
    derived: Derived,
    lacks: tuple[Lacking, ...],
) -> str:
    return json_text(
        {
            "atlas": name,
            "unit": unit,
            "landmarks": [row for row in rows if row["origin"] != "missing"],
            "missing": [
                {"name": name, "reason": reason} for name, reason in derived.missing.items()
            ],
            "lacking": [
                {
                    "key": lack.measurement.key,
                    "name": lack.measurement.name,
                    "landmarks": list(lack.landmarks),
                }
                for lack in lacks
            ],
        }
    )


def _print(
    rows: list[dict[str, Any]], derived: Derived, lacks: tuple[Lacking, ...], unit: str
) -> None:
    there = [row for row in rows if row["origin"] != "missing"]
    if there:
        print_table(_table(there, unit))
    else:
        RESULTS.print(Text("The atlas has no landmark; `bodymeasure landmarks add` adds one."))
    if derived.missing:
        RESULTS.print(Text("\nMissing:"))
        for name, reason in derived.missing.items():
            RESULTS.print(Text.assemble("  ", (name, "yellow"), f": {reason}"), soft_wrap=True)
    if lacks:
        RESULTS.print(Text("\nMeasurements that lack landmarks:"))
        for lack in lacks:
            names = ", ".join(lack.landmarks)
            line = Text.assemble("  ", lack.measurement.name, ": ", (names, "yellow"))
            RESULTS.print(line, soft_wrap=True)


def _table(rows: list[dict[str, Any]], unit: str) -> Table:
    table = Table(box=None, pad_edge=False)
    table.add_column("landmark", overflow="fold")
    table.add_column("patch", overflow="fold")
    for heading in ("u", "v", f"x/{unit}", f"y/{unit}", f"z/{unit}"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("origin", overflow="fold")
    for row in rows:
        table.add_row(
            Text(row["name"]),
            Text(row["patch"]),
            *(f"{row[key]:.{PARAMETER_DECIMALS}f}" for key in ("u", "v")),
            *(fixed(row[key], DECIMALS[unit]) for key in ("x", "y", "z")),
            Text(row["remark"] or row["origin"]),
        )
    return table


def fixed(value: float, decimals: int) -> str:
    """A number with so many decimals; never minus zero."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}"
