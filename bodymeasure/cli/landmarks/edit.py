"""`bodymeasure landmarks add` and `remove`."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.text import Text

from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_note
from bodymeasure.cli.inputs import load_atlas
from bodymeasure.cli.options import atlas_argument
from bodymeasure.errors import InputError
from bodymeasure.formats import write_atlas
from bodymeasure.formats.registry import EXTENSIONS
from bodymeasure.samples import sample_names
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from bodymeasure.chart.picks.picking import Pick

_Command = Callable[..., Any]


def _output_options(command: _Command) -> _Command:
    for option in (
        click.option("--in-place", is_flag=True, help="Write to ATLAS itself."),
        click.option(
            "-o",
            "--output",
            type=click.Path(path_type=Path),
            metavar="FILE",
            help="Write the atlas to this file.",
        ),
    ):
        command = option(command)
    return command


@click.command(short_help="Add or move landmarks.", epilog=EXIT_CODES)
@atlas_argument
@click.argument("name", required=False)
@click.option(
    "--at",
    type=float,
    nargs=3,
    metavar="X Y Z",
    help="Take the closest point to a position; needs --position-unit.",
)
@click.option("--patch", metavar="NAME", help="Take a point of this patch; needs --uv.")
@click.option("--uv", type=float, nargs=2, metavar="U V", help="Parameters, from 0 to 1.")
@click.option(
    "--mesh",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Take the closest point to a vertex of this OBJ, OFF or PLY file; needs --vertex and "
    "--position-unit.",
)
@click.option(
    "--vertex",
    type=int,
    metavar="N",
    help="Number of the vertex, counted from 0, as in Blender and MeshLab.",
)
@click.option(
    "--from-one",
    is_flag=True,
    help="--vertex is counted from 1, as in the faces of an OBJ file.",
)
@click.option(
    "--from",
    "source",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Take several at once: the closest points to positions in a CSV file with the columns "
    "name, x, y, z; needs --position-unit.",
)
@click.option(
    "--position-unit",
    "unit",
    type=click.Choice([unit.value for unit in Unit]),
    help="Unit of the positions, or of the mesh.",
)
@click.option("--far", is_flag=True, help="Accept positions farther than 2 cm from the body.")
@click.option("--replace", "replacing", is_flag=True, help="Move landmarks that are there already.")
@_output_options
def add(
    atlas: str,
    name: str | None,
    output: Path | None,
    in_place: bool,
    replacing: bool,
    **places: Any,
) -> None:
    """Add a landmark called NAME to ATLAS, and write the atlas to a file; or several, with --from.

    The place is given in one of four ways: by --at, by --patch and --uv, by --mesh and --vertex, or
    by --from.
    """
    from bodymeasure.chart.picks.picking import with_landmarks

    target = _target(atlas, output, in_place=in_place)
    loaded = load_atlas(atlas)
    picks = _picks(loaded, name, **places)
    changed = with_landmarks(loaded, picks, replacing=replacing)
    write_atlas(changed, target)
    for pick in picks:
        _print_pick(loaded, pick, places["unit"])
    _print_written(changed, target)


@click.command(short_help="Remove landmarks.", epilog=EXIT_CODES)
@atlas_argument
@click.argument("names", nargs=-1, required=True, metavar="NAME...")
@_output_options
def remove(atlas: str, names: tuple[str, ...], output: Path | None, in_place: bool) -> None:
    """Remove the landmarks called NAME from ATLAS, and write the atlas to a file."""
    from bodymeasure.chart.picks.picking import without_landmarks

    target = _target(atlas, output, in_place=in_place)
    changed = without_landmarks(load_atlas(atlas), names)
    write_atlas(changed, target)
    _print_written(changed, target)


def _target(atlas: str, output: Path | None, *, in_place: bool) -> Path:
    """Return the file to write to, or refuse it before any work."""
    if (output is not None) == in_place:
        raise click.UsageError("Give either -o FILE or --in-place: where to write the atlas to.")
    if output is None and atlas in sample_names() and not Path(atlas).is_file():
        raise InputError(f"{atlas} is a sample, which stays as it is; write to a file with -o FILE")
    target = Path(atlas) if output is None else output
    keeping = [end for end, form in EXTENSIONS.items() if "landmarks" in form.keeps]
    if target.suffix.lower() not in keeping:
        raise InputError(
            f"{target}: {target.suffix or 'such'} files hold no landmarks; write to one of "
            f"{', '.join(keeping)} with -o FILE"
        )
    return target


def _picks(
    atlas: Atlas,
    name: str | None,
    *,
    at: tuple[float, float, float] | None,
    patch: str | None,
    uv: tuple[float, float] | None,
    mesh: Path | None,
    vertex: int | None,
    from_one: bool,
    source: Path | None,
    unit: str | None,
    far: bool,
) -> "tuple[Pick, ...]":
    import numpy as np

    from bodymeasure.chart.picks.file import read_picks
    from bodymeasure.chart.picks.picking import Pick, nearest_picks

    _check_usage(
        {"--at": at, "--patch": patch, "--mesh": mesh, "--from": source},
        {"--uv": (uv, "--patch", patch), "--vertex": (vertex, "--mesh", mesh)},
        name,
        unit,
    )
    if from_one and mesh is None:
        raise click.UsageError("--from-one says how --vertex counts; it needs --mesh.")
    if source is not None:
        names, positions = read_picks(source)
        return nearest_picks(atlas, names, positions, str(unit), far=far)
    if patch is not None and uv is not None:
        return (Pick(str(name), AtlasPoint(atlas.patch_number(patch), *uv)),)
    position = at if mesh is None else _vertex(mesh, int(vertex or 0), from_one=from_one)
    return nearest_picks(
        atlas, (str(name),), np.array([position], dtype=np.float64), str(unit), far=far
    )


def _check_usage(
    ways: dict[str, object],
    pairs: dict[str, tuple[object, str, object]],
    name: str | None,
    unit: str | None,
) -> None:
    given = [way for way, value in ways.items() if value is not None]
    if len(given) != 1:
        found = " and ".join(given) if given else "none"
        raise click.UsageError(
            f"Say where the landmark is in one way of --at, --patch, --mesh and --from; "
            f"got {found}."
        )
    for option, (value, partner, there) in pairs.items():
        if (value is None) != (there is None):
            raise click.UsageError(f"{partner} and {option} belong together; give both or none.")
    if (name is None) != (given[0] == "--from"):
        raise click.UsageError(
            "--from takes the names from its file; leave NAME out."
            if name is not None
            else "Missing argument 'NAME': what the landmark is called."
        )
    if (unit is None) != (given[0] == "--patch"):
        raise click.UsageError(
            f"{given[0]} needs --position-unit, the unit of the position: m, cm, mm or inch."
            if unit is None
            else "--position-unit is for positions; --patch has none."
        )


def _vertex(path: Path, number: int, *, from_one: bool) -> list[float]:
    from bodymeasure.formats.mesh_vertices import mesh_vertices

    vertices = mesh_vertices(path)
    first = 1 if from_one else 0
    if not first <= number < first + len(vertices):
        raise InputError(
            f"{path} has no vertex {number}: its {len(vertices):,} vertices are numbered from "
            f"{first} to {first + len(vertices) - 1}"
            + ("" if from_one else " (or give --from-one, if yours are counted from 1)")
        )
    position: list[float] = vertices[number - first].tolist()
    return position


def _print_pick(atlas: Atlas, pick: "Pick", unit: str | None) -> None:
    from bodymeasure.chart import load_definitions, names_in
    from bodymeasure.chart.landmarks.names import suggested_name

    point = pick.point
    words = f"{pick.name}: {atlas.patch_names[point.patch]}, u = {point.u:.6f}, v = {point.v:.6f}"
    if unit is not None:
        distance = pick.distance * atlas.unit.meters / Unit.parse(unit).meters
        words += f", {distance:.2g} {unit} from the position"
    RESULTS.print(Text(words), soft_wrap=True)
    suggested = suggested_name(pick.name, names_in(load_definitions()))
    if suggested is not None:
        print_note(f"{pick.name!r} is no name that measurements use; did you mean {suggested!r}?")


def _print_written(atlas: Atlas, target: Path) -> None:
    RESULTS.print(Text(f"{target}: {counted(len(atlas.landmarks), 'landmark')}"), soft_wrap=True)
