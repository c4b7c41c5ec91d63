"""Arguments and options that several commands share, and what users gave with them."""

import math
import os
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import click

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.atlas.axes import DIRECTIONS

DEFAULT_SAMPLE = "female_average"

# The key under which `load_atlas` finds what the user says about the file that it is to read.
_FILE_OPTIONS = f"{__name__}.file_options"
# The same for the model whose topology a scan has, of which readers of atlases know nothing.
_TOPOLOGY = f"{__name__}.topology"
_Command = TypeVar("_Command", bound=Callable[..., Any])


class NumberRange(click.FloatRange):
    """Numbers between bounds: click lets nan pass, which is neither below nor above any."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Return the number, or say what is wrong with it."""
        number = float(super().convert(value, param, ctx))
        if math.isnan(number):
            self.fail(f"{value!r} is no number.", param, ctx)
        return number


def _keep(ctx: click.Context, parameter: click.Parameter, value: str | bool | None) -> None:
    if value:
        name = str(parameter.name).removeprefix("file_")
        ctx.meta.setdefault(_FILE_OPTIONS, {})[name] = value


def _keep_topology(ctx: click.Context, _parameter: click.Parameter, value: str | None) -> None:
    if value is not None:
        ctx.meta[_TOPOLOGY] = value


def _file_option(name: str, choices: Sequence[str], words: str) -> Callable[[_Command], _Command]:
    kind = click.Choice(choices)
    return click.option(name, type=kind, expose_value=False, callback=_keep, help=words)


def file_options(command: _Command) -> _Command:
    """Add the options that say what the format of an atlas's file leaves out."""
    return scan_options(quads_option(command))


def quads_option(command: _Command) -> _Command:
    """Add the option that takes a mesh of triangles for an atlas."""
    return click.option(
        "--quads",
        is_flag=True,
        expose_value=False,
        callback=_keep,
        help="Make patches of a mesh of triangles, too, three or more for each.",
    )(command)


def scan_options(command: _Command) -> _Command:
    """Add the options that say what the file of a scan leaves out."""
    for name, choices, words in (
        (
            "--front",
            DIRECTIONS,
            "Direction in which the body looks; -y by default, or found in a scan.",
        ),
        (
            "--up",
            DIRECTIONS,
            "Direction of up, if the file's format has none; +z by default, or found in a scan.",
        ),
        (
            "--file-unit",
            [unit.value for unit in Unit],
            "Unit of the file's coordinates, if its format has none; it is never guessed.",
        ),
    ):
        command = _file_option(name, choices, words)(command)
    return command


def _of_atlas(name: str = "atlas", **settings: Any) -> Callable[[_Command], _Command]:
    """Return the argument ATLAS together with the options that `load_atlas` reads."""
    argument = click.argument(name, **settings)
    return lambda command: argument(file_options(command))


atlas_argument = _of_atlas(metavar="ATLAS")
optional_atlas_argument = _of_atlas(metavar="[ATLAS]", default=DEFAULT_SAMPLE, required=False)
several_atlases_argument = _of_atlas("atlases", metavar="[ATLAS]...", nargs=-1)
_meshes = click.argument("meshes", metavar="MESH...", nargs=-1, required=True)


def several_scans_argument(command: _Command) -> _Command:
    """Add the argument MESH... together with the options that a fit reads."""
    return _meshes(scan_options(command))


# The choice of a unit that stands for the one of the atlas's own file.
OWN = "file"
unit_option = click.option(
    "--unit",
    type=click.Choice([*(unit.value for unit in Unit), OWN]),
    default=Unit.CM.value,
    show_default=True,
    help=f"Unit of the lengths; {OWN!r} is that of the atlas.",
)
despite_errors_option = click.option(
    "--despite-errors",
    is_flag=True,
    help="Measure an atlas in spite of errors that its check finds; look at each status then.",
)
definitions_option = click.option(
    "--set",
    "definitions",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="File of definitions of the measurements; the default set if not given.",
)
paths_option = click.option(
    "--paths",
    "paths_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the paths as curves to FILE, in the atlas's unit: .3dm, .step, .obj, .json, .svg.",
)
only_option = click.option(
    "--only",
    metavar="KEYS",
    callback=lambda _ctx, _parameter, value: names_in_list(value),
    help="Only these measurements, separated by commas: keys, which may lack their _left or "
    "_right, and presets such as core, tops and trousers.",
)
picks_option = click.option(
    "--landmarks",
    "picks",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="CSV file of landmarks that you picked on the scan, with the columns name, x, y and z in "
    "the scan's own coordinates; they win over those of the body model, and pull the fit.",
)
topology_option = click.option(
    "--topology",
    metavar="NAME",
    expose_value=False,
    callback=_keep_topology,
    help="The model whose vertices and faces the mesh has: a file that `bodymeasure fit "
    "--save-topology` wrote, or 'hm08' or 'hm08 faces' for MakeHuman's. Its bodies are mapped at "
    "once, without a search.  [default: hm08 is recognized, others are fitted]",
)
# Options whose help, and whose default, differ from command to command.
folder_option = partial(
    click.option,
    *("-o", "--output"),
    type=click.Path(path_type=Path, file_okay=True),
    metavar="FOLDER",
    show_default=True,
)
format_option = partial(
    click.option,
    *("--format", "form"),
    type=click.Choice(["table", "csv", "json"]),
    default="table",
    show_default=True,
)
no_pictures_option = click.option("--no-pictures", is_flag=True, help="Leave out the pictures.")
all_pictures_option = click.option(
    "--all-pictures",
    is_flag=True,
    help="Draw everything from near as well, which the page otherwise shows in its scene to turn.",
)
no_cross_check_option = click.option(
    "--no-cross-check",
    is_flag=True,
    help="Leave out the comparison with meshes, which takes most of the time.",
)
check_option = click.option(
    "--check",
    type=click.Choice(("flips", "libigl")),
    default="flips",
    show_default=True,
    help="What measures on the meshes: edge flips, of which libigl confirms a sample, each "
    "disagreement and the worst cases; or libigl everything, in four times the time.",
)
processes_option = click.option(
    "--processes",
    type=click.IntRange(min=1),
    metavar="N",
    default=lambda: available_cores(),
    show_default="all cores",
    help="Worker processes of the comparison.",
)


def names_in_list(text: str | None) -> tuple[str, ...]:
    """Return the names in a list with commas; an option that was not given has none.

    Raises
    ------
    click.BadParameter
        If the list is there, but has no name in it.
    """
    names = tuple(name for name in map(str.strip, (text or "").split(",")) if name)
    if text is not None and not names:
        raise click.BadParameter(
            f"{text!r} names nothing; expected names with commas between them."
        )
    return names


def length_unit(unit: str, atlas: Atlas) -> str:
    """Return the unit in which lengths are shown."""
    return atlas.unit.value if unit == OWN else unit


def available_cores() -> int:
    """Return the number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def file_settings() -> dict[str, Any]:
    """Return what the user says about a file: its unit, where up and the front are, and quads."""
    context = click.get_current_context(silent=True)
    return {} if context is None else dict(context.meta.get(_FILE_OPTIONS, {}))


def given_topology() -> str | None:
    """Return the model whose topology the user says that a mesh has."""
    context = click.get_current_context(silent=True)
    return None if context is None else context.meta.get(_TOPOLOGY)
