"""Arguments and options that several commands share."""

import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeVar

import click

from bodymeasure.atlas import Atlas, FindingKind, Severity, Unit, check_atlas
from bodymeasure.atlas.axes import DIRECTIONS
from bodymeasure.cli.console import print_note
from bodymeasure.errors import InputError, MissingExtraError, ReadWarning
from bodymeasure.formats import format_of, read_atlas
from bodymeasure.samples import sample_names, sample_path
from bodymeasure.wording import nearest

DEFAULT_SAMPLE = "female_average"
# The number of errors that a message lists; the others are counted.
LISTED = 3
# Similarity of names from which on one is taken for a misspelling of the other.
NEAR = 0.7
# The needs of features: a name for the feature, the module, its package, and the extra that
# installs the package.
COMPARISON = ("the comparison (--no-cross-check leaves it out)", "igl", "libigl", "oracle")
PICTURES = ("drawing (--no-pictures leaves it out)", "matplotlib", "matplotlib", "report")
PAGE = ("the HTML report", "jinja2", "jinja2", "report")
CHART_PAGE = ("the page of measurements", "jinja2", "jinja2", "chart")
CHART_PICTURES = ("drawing (--no-pictures leaves it out)", "matplotlib", "matplotlib", "chart")
BENCHMARK = (
    ("the benchmark", "igl", "libigl", "bench"),
    ("the benchmark", "potpourri3d", "potpourri3d", "bench"),
)
BENCHMARK_FIGURE = ("the benchmark's figure", "matplotlib", "matplotlib", "bench")
VIEWER = ("the viewer", "pyvista", "pyvista", "viewer")
VIEWER_COLORS = ("the viewer", "matplotlib", "matplotlib", "viewer")

# The key under which `load_atlas` finds what the user says about the file that it is to read.
_FILE_OPTIONS = f"{__name__}.file_options"
# The same for the model whose topology a scan has, of which readers of atlases know nothing.
_TOPOLOGY = f"{__name__}.topology"
_Command = TypeVar("_Command", bound=Callable[..., Any])


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
    help="Leave out the comparison with libigl, which takes most of the time.",
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


def load_atlas(
    name: str, *, if_none: bool = False, corrected: bool = False, **options: Any
) -> Atlas:
    """Return an atlas from a file, or a sample by its name if there is no such file.

    `options` are those of `read_atlas`; the unit and the axes are those that the user gave for the
    file. With `if_none`, they are left out where the file has its own; with `corrected`, such axes
    take the place of the file's own.

    Raises
    ------
    InputError
        If it is neither, or not a valid atlas.
    """
    path = path_of_atlas(name)
    given = file_settings()
    if if_none and given:
        kept = format_of(path).keeps
        # Formats with landmarks are those of bodymeasure, which have axes too.
        had = {"unit": "unit", "up": "landmarks", "front": "landmarks"}
        given = {key: value for key, value in given.items() if had.get(key) not in kept}
    axes = {}
    if corrected and "landmarks" in format_of(path, options.get("format")).keeps:
        axes = {key: given.pop(key) for key in ("up", "front") if key in given}
    with _notes():
        atlas = read_atlas(path, **given, **options)
    return replace(atlas, axes=replace(atlas.axes, **axes)) if axes else atlas


def file_settings() -> dict[str, Any]:
    """Return what the user says about a file: its unit, where up and the front are, and quads."""
    context = click.get_current_context(silent=True)
    return {} if context is None else dict(context.meta.get(_FILE_OPTIONS, {}))


def given_topology() -> str | None:
    """Return the model whose topology the user says that a mesh has."""
    context = click.get_current_context(silent=True)
    return None if context is None else context.meta.get(_TOPOLOGY)


def lacks_unit(name: str) -> bool:
    """Whether the format of an atlas's file has no unit."""
    return "unit" not in format_of(path_of_atlas(name)).keeps


def path_of_atlas(name: str) -> Path:
    """Return the file of an atlas or a sample, which may not be there.

    Raises
    ------
    InputError
        If there is neither such a file nor such a sample; the message suggests a sample.
    """
    path = Path(name)
    # A folder may have the name of the sample whose report it holds.
    if name in sample_names() and not _is_file(path):
        return sample_path(name)
    if len(path.parts) == 1 and not _exists(path):
        # A name with an extension means a file, unless it is nearly the name of a sample.
        near = nearest(path.stem, sample_names(), similarity=NEAR)
        hint = "`bodymeasure samples` lists the samples"
        if near:
            hint = f"did you mean the sample {near!r}?"
        if near or not path.suffix:
            raise InputError(f"{name}: no such file, and no sample of that name; {hint}")
    return path


@contextmanager
def _notes() -> Iterator[None]:
    """Print the notes of reading a file as the command line prints notes."""
    show = warnings.showwarning

    def print_or_show(message: Any, category: Any, *rest: Any, **others: Any) -> None:
        if issubclass(category, ReadWarning):
            print_note(str(message))
        else:
            show(message, category, *rest, **others)

    with warnings.catch_warnings():
        warnings.simplefilter("always", ReadWarning)
        warnings.showwarning = print_or_show
        yield


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except OSError:  # such as a name that is too long; reading it will say so
        return True


def _is_file(path: Path) -> bool:
    return _exists(path) and not path.is_dir()


def require(*needs: tuple[str, str, str, str]) -> None:
    """Refuse, before any work, what would fail at its end because a package is missing.

    Raises
    ------
    MissingExtraError
        The feature, the package it needs, and how to install it.
    """
    for feature, module, package, extra in needs:
        if find_spec(module) is None:
            raise MissingExtraError(feature, package, extra)


def load_sound_atlas(name: str, *, despite_errors: bool, if_none: bool = False) -> Atlas:
    """Return an atlas as `load_atlas` does; refuse one whose check finds errors.

    Raises
    ------
    InputError
        If errors were found and `despite_errors` is false: the errors, and what to do.
    """
    atlas = load_atlas(name, if_none=if_none)
    require_sound(atlas, name, despite_errors=despite_errors)
    return atlas


def require_sound(atlas: Atlas, name: str, *, despite_errors: bool) -> None:
    """Refuse an atlas whose check finds errors.

    Raises
    ------
    InputError
        If errors were found and `despite_errors` is false: the errors, and what to do.
    """
    if despite_errors:
        return
    findings = check_atlas(atlas)
    errors = [f"{f.kind}: {f.message}" for f in findings if f.severity == Severity.ERROR]
    if errors:
        more = f"\n  and {len(errors) - LISTED} more" if len(errors) > LISTED else ""
        listed = "".join(f"\n  {message}" for message in errors[:LISTED])
        raise InputError(
            f"{name}: the atlas has {len(errors)} error{'s' if len(errors) > 1 else ''}:{listed}"
            f"{more}\nRepair it (`bodymeasure check` lists all), or measure --despite-errors."
        )
    for finding in findings:
        # Other warnings leave lengths as they are; this one multiplies all of them.
        if finding.kind == FindingKind.SIZE:
            print_note(f"{name}: {finding.message}.")
