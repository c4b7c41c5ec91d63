"""`bodymeasure landmarks check`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.cli.console import RESULTS, counted, print_table
from bodymeasure.cli.landmarks_list import DECIMALS, csv_text, fixed, format_option, json_text
from bodymeasure.cli.options import EXIT_CODES, atlas_argument, load_atlas, unit_option

if TYPE_CHECKING:
    from bodymeasure.chart.symmetry import SymmetryCheck

EXIT_FOUND = 1
# In metres: experienced measurers put a landmark on a body again within about that.
WITHIN = 0.005
COLUMNS = ("name", "kind", "distance", "remark")
Row = dict[str, Any]


@click.command(
    "check", short_help="Check that landmarks are symmetric and well named.", epilog=EXIT_CODES
)
@atlas_argument
@click.option(
    "--plane",
    type=click.Choice(["fitted", "axes"]),
    default="fitted",
    show_default=True,
    help="The mirror: the plane in which the surface is most nearly symmetric, or the one across "
    "the atlas's axes through the median landmarks.",
)
@click.option(
    "--within",
    type=click.FloatRange(min=0.0),
    metavar="LENGTH",
    help="What counts as symmetric, in --unit.  [default: 5 mm]",
)
@format_option
@unit_option
def check_landmarks(
    atlas: str, plane: Literal["fitted", "axes"], within: float | None, form: str, unit: str
) -> int:
    """Check that the left landmarks of ATLAS are mirror images of the right ones.

    Told are the distance of each mirrored left landmark from its partner, landmarks without a
    partner, those without a side that lie off the plane, and names that look like misspelled ones
    of ISO 8559-1. Anything of these ends with exit code 1.
    """
    from bodymeasure.chart.symmetry import check_symmetry

    loaded = load_atlas(atlas)
    found = check_symmetry(loaded, plane)
    limit = WITHIN / Unit.parse(unit).metres if within is None else within
    rows = _rows(loaded, found, Unit.parse(unit), limit)
    to_look_at = [row for row in rows if row["remark"]]
    if form == "csv":
        click.echo(csv_text(COLUMNS, rows).encode(), nl=False)
    elif form == "json":
        click.echo(_json(loaded.name or atlas, found, rows, loaded, unit).encode(), nl=False)
    else:
        if rows:
            print_table(_table(rows, unit))
        RESULTS.print(Text(_summary(loaded, found, len(to_look_at), unit)), soft_wrap=True)
    return EXIT_FOUND if to_look_at else 0


def _rows(atlas: Atlas, found: SymmetryCheck, unit: Unit, limit: float) -> list[Row]:
    from bodymeasure.chart.landmark_names import other_side, suggested_name

    scale = atlas.unit.metres / unit.metres
    rows: list[Row] = []
    for pair in found.pairs:
        apart = scale * pair.apart
        remark = f"not the mirror image of {pair.right}" if apart > limit else ""
        rows.append({"name": pair.left, "kind": "pair", "distance": apart, "remark": remark})
    for name, away in found.median:
        remark = ""
        if abs(scale * away) > limit:
            remark = f"off the median plane, to the {'left' if away > 0.0 else 'right'}"
        rows.append(
            {"name": name, "kind": "median", "distance": abs(scale * away), "remark": remark}
        )
    for name in found.unpaired:
        remark = f"has no partner {other_side(name)}"
        rows.append({"name": name, "kind": "unpaired", "distance": "", "remark": remark})
    for name in atlas.landmarks:
        suggested = suggested_name(name)
        if suggested is not None:
            remark = f"no name that measurements use; did you mean {suggested}?"
            rows.append({"name": name, "kind": "name", "distance": "", "remark": remark})
    return rows


def _table(rows: list[Row], unit: str) -> Table:
    table = Table(box=None, pad_edge=False)
    table.add_column("landmark", overflow="fold")
    table.add_column("checked", no_wrap=True)
    table.add_column(f"off by/{unit}", justify="right", no_wrap=True)
    table.add_column("remark", overflow="fold")
    for row in rows:
        distance = row["distance"]
        table.add_row(
            Text(row["name"]),
            row["kind"],
            fixed(distance, DECIMALS[unit]) if distance != "" else "",
            Text(row["remark"], "yellow"),
        )
    return table


def _plane_words(atlas: Atlas, found: SymmetryCheck, unit: str) -> str:
    scale = atlas.unit.metres / Unit.parse(unit).metres
    point, normal = scale * found.plane.point, found.plane.normal
    words = {
        "fitted": "the plane in which the surface is most nearly symmetric",
        "axes": "the plane across the atlas's axes through its median landmarks",
    }[found.kind]
    place = ", ".join(fixed(x, DECIMALS[unit]) for x in point)
    direction = ", ".join(fixed(x, 4) for x in normal)
    return f"{words}, through ({place}) {unit} with normal ({direction})"


def _summary(atlas: Atlas, found: SymmetryCheck, to_look_at: int, unit: str) -> str:
    scale = atlas.unit.metres / Unit.parse(unit).metres
    deviation = fixed(scale * found.deviation, DECIMALS[unit])
    return (
        f"Mirror: {_plane_words(atlas, found, unit)}; the surface deviates from its mirror image "
        f"by {deviation} {unit} (root mean square).\n"
        f"{counted(len(atlas.landmarks), 'landmark')}, {to_look_at} to look at"
    )


def _json(name: str, found: SymmetryCheck, rows: list[Row], atlas: Atlas, unit: str) -> str:
    scale = atlas.unit.metres / Unit.parse(unit).metres
    return json_text(
        {
            "atlas": name,
            "unit": unit,
            "plane": {
                "kind": found.kind,
                "point": (scale * found.plane.point).tolist(),
                "normal": found.plane.normal.tolist(),
            },
            "deviation": scale * found.deviation,
            "landmarks": [
                {**row, "distance": None if row["distance"] == "" else row["distance"]}
                for row in rows
            ],
        }
    )
