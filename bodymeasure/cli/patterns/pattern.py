"""`bodymeasure pattern`."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from click.core import ParameterSource
from rich.text import Text

from bodymeasure.atlas import Atlas
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_files, print_note, print_table, progress_bar
from bodymeasure.cli.inputs import load_sound_atlas
from bodymeasure.cli.measuring.subjects import Subject, subjects_of
from bodymeasure.cli.needs import require
from bodymeasure.cli.options import (
    DEFAULT_SAMPLE,
    NumberRange,
    despite_errors_option,
    folder_option,
    names_in_list,
    several_atlases_argument,
)
from bodymeasure.cli.patterns.files import formats_option, needs_of, paper_option
from bodymeasure.cli.patterns.lengths import eases
from bodymeasure.cli.tables import new_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder, write_all
from bodymeasure.wording import counted, hint

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.pattern import Pattern

EXIT_LOOK = 1
CUTTING = ("cutting pieces out of the skin", "shapely", "shapely", "pattern")
# Parameters that say nothing to patches which are unfolded by themselves.
OF_PANELS = ("definitions", "sizes", "allowance", "ease", "formats", "paper", "bridge")
# The sets that come along, for the help.
NAMES = "bodice, princess, skirt, sleeve or trousers"


def _print_set(ctx: click.Context, _parameter: click.Parameter, name: str | None) -> None:
    if name is None or ctx.resilient_parsing:
        return
    from bodymeasure.pattern import SETS, set_text

    if name not in SETS:
        raise InputError(f"no set is named {name!r}; {hint(name, SETS)}")
    click.echo(set_text(name), nl=False)
    ctx.exit()


@click.command(epilog=EXIT_CODES)
@several_atlases_argument
@click.option(
    "--set",
    "definitions",
    default="bodice",
    show_default=True,
    metavar="SET",
    help=f"The panels: {NAMES}, or a file of yours.",
)
@folder_option(default=Path("pattern"), help="Folder for the files; made if it is not there.")
@click.option(
    "--sizes",
    callback=lambda _ctx, _parameter, value: names_in_list(value),
    metavar="NAMES",
    help="Names of the sizes of several bodies, with commas between them, in the order of the "
    "bodies.  [default: the names of the files]",
)
@click.option(
    "--allowance",
    type=NumberRange(min=0.0, max=10.0),
    default=1.0,
    show_default=True,
    metavar="CM",
    help="Allowance of seams in cm, but at folds, and where the set says otherwise.",
)
@click.option(
    "--ease",
    callback=eases,
    metavar="LEVELS",
    help="By how much girths are wider than the body's, such as bust=4cm,waist=2cm: at neck, bust, "
    "waist, hip, or the height of any landmark, and between them in turn.  [default: the set's]",
)
@formats_option
@paper_option
@click.option(
    "--bridge/--no-bridge",
    default=None,
    help="Whether the cloth bridges hollows inside of pieces, as under a bust, rather than follow "
    "the skin.  [default: as the set says]",
)
@click.option(
    "--print-set",
    metavar="SET",
    is_eager=True,
    expose_value=False,
    callback=_print_set,
    help=f"Print the file of a set ({NAMES}), which may be copied and changed, and exit.",
)
@click.option(
    "--patches",
    is_flag=True,
    help="Unfold each patch by itself instead, as the paper does: patches.svg, colored by the "
    "misfit, and patches.csv.",
)
@despite_errors_option
def pattern(
    atlases: tuple[str, ...],
    definitions: str,
    output: Path,
    sizes: tuple[str, ...],
    allowance: float,
    ease: dict[str, float] | None,
    formats: tuple[str, ...],
    paper: str,
    bridge: bool | None,
    patches: bool,
    despite_errors: bool,
) -> int:
    """Make the flat pieces of a garment from ATLAS, whose seams are as long as on the body.

    ATLAS is the average female sample if not given. FOLDER gets a page, pattern.html, which shows
    where the cloth has to give and lists all seams; the pieces in true size as pattern.svg, as
    pattern.pdf in tiles, and as pattern.dxf for cutting rooms; garmentcode.json, with what is sewn
    to what; strain.svg; and pattern.json with all lengths.

    Several bodies are the sizes of one garment: each is cut on its own body, and its files go into
    a folder in FOLDER by the name of the size. The drawings in FOLDER itself have all sizes over
    each other.

    A dart that would not open is left out, and said; the exit code is 1 only if a piece or a seam
    is not right.
    """
    names = atlases or (DEFAULT_SAMPLE,)
    if patches:
        if len(names) > 1:
            raise click.UsageError("--patches unfolds one body; unfold them one by one.")
        _refuse_options_of_panels()
        return _patches(load_sound_atlas(names[0], despite_errors=despite_errors), output)
    require(CUTTING, *needs_of(formats))
    # Slow imports, which `--help` does not need.
    from bodymeasure.pattern import GradedPattern, grade_pattern, load_pattern, make_pattern
    from bodymeasure.report.patterns import pattern_files

    panels = load_pattern(definitions)
    load = partial(load_sound_atlas, despite_errors=despite_errors, if_none=len(names) > 1)
    bodies = _by_size(subjects_of(names, load, despite_errors=despite_errors), sizes)
    graded = len(bodies) > 1
    # Folders that are removed again if the work fails.
    folders = [output, *(output / size for size in bodies if graded)]
    with ExitStack() as stack:
        for folder in folders:
            stack.enter_context(output_folder(folder))
        made: Pattern | GradedPattern
        bar = progress_bar("laying flat", len(panels.panel) * len(bodies))
        with _naming(definitions), bar as progress:
            advance: Callable[[int, int], None] = lambda done, _all: progress(done)  # noqa: E731
            if graded:
                made = grade_pattern(bodies, panels, ease=ease, bridge=bridge, progress=advance)
            else:
                (body,) = bodies.values()
                made = make_pattern(body, panels, ease=ease, bridge=bridge, progress=advance)
        contents = pattern_files(made, formats=formats, allowance=10.0 * allowance, paper=paper)
        files = {output / name: content for name, content in contents.items()}
        write_all(files)
    patterns = made.patterns if isinstance(made, GradedPattern) else {"": made}
    for size, one in patterns.items():
        if graded:
            RESULTS.print(Text(size, style="bold"))
        print_table(_table(one))
        _print_seams(one)
    print_files(files)
    for words in made.warnings:
        print_note(words)
    return 0 if made.is_sound else EXIT_LOOK


@contextmanager
def _naming(definitions: str) -> Iterator[None]:
    """Name the user's file in what cannot be done with its panels."""
    from bodymeasure.pattern import SETS

    try:
        yield
    except InputError as error:
        if definitions in SETS or "panel '" not in str(error):
            raise
        raise InputError(f"{definitions}: {error}") from error


def _refuse_options_of_panels() -> None:
    """Refuse what says how panels are cut, where patches are unfolded that have none."""
    ctx = click.get_current_context()
    for parameter in ctx.command.params:
        given = ctx.get_parameter_source(str(parameter.name)) is ParameterSource.COMMANDLINE
        if given and parameter.name in OF_PANELS:
            raise click.UsageError(
                f"--patches unfolds patches without panels; leave out {parameter.opts[0]}."
            )


def _by_size(bodies: list[Subject], sizes: tuple[str, ...]) -> dict[str, Atlas]:
    """Return bodies by the names of their sizes, which name folders, too."""
    if sizes and len(sizes) != len(bodies):
        given = counted(len(bodies), "body", "bodies")
        raise click.UsageError(
            f"--sizes names {counted(len(sizes), 'size')} for {given}; name one for each body."
        )
    names = sizes or tuple(subject.name for subject in bodies)
    for name in names:
        if names.count(name) > 1:
            raise click.UsageError(f"--sizes names {name!r} twice; name each size once.")
        if len(names) > 1 and (set(name) & set('/\\:*?"<>|\0') or name.strip(". ") != name):
            raise click.UsageError(
                f"{name!r} cannot name a folder; name the sizes by --sizes, in letters and digits."
            )
    return {name: subject.atlas for name, subject in zip(names, bodies, strict=True)}


def _table(made: "Pattern") -> "Table":
    scale = 1000.0 * made.atlas.unit.meters
    table = new_table("piece", "strain, rms", "at most", "darts", words=("darts",))
    for piece in made.pieces:
        darts = ", ".join(f"{dart.name} {scale * dart.intake:.0f} mm" for dart in piece.darts)
        table.add_row(
            Text(piece.name),
            f"{100.0 * piece.rms_strain:.1f} %",
            f"{100.0 * float(np.abs(piece.strains).max()):.0f} %",
            Text(darts),
        )
    return table


def _print_seams(made: "Pattern") -> None:
    if not made.seams:
        return
    scale = 1000.0 * made.atlas.unit.meters
    worst = max(abs(scale * seam.excess) for seam in made.seams)
    words = (
        f"{counted(len(made.seams), 'seam')} between pieces; both sides differ by at most "
        f"{worst:{'.1g' if worst < 1.0 else '.1f'}} mm"
    )
    if any(seam.ease for seam in made.seams):
        words += ", apart from what is eased into a seam"
    RESULTS.print(Text(words), soft_wrap=True)


def _patches(loaded: Atlas, output: Path) -> int:
    with output_folder(output):
        from bodymeasure.pattern import patches_sheet, patches_table, unfold_patches

        unfolded = unfold_patches(loaded)
        files = {
            output / "patches.svg": patches_sheet(unfolded).encode(),
            output / "patches.csv": patches_table(unfolded).encode(),
        }
        write_all(files)
    worst = 1000.0 * loaded.unit.meters * unfolded.worst
    turned = int(unfolded.turned_over.sum())
    words = (
        f"{counted(len(loaded), 'patch', 'patches')}: misfit {np.median(worst):.2f} mm in the "
        f"median, {np.percentile(worst, 95):.2f} mm for 95 %, {worst.max():.2f} mm at most; "
        f"{turned or 'none'} turned over"
    )
    RESULTS.print(Text(words), soft_wrap=True)
    print_files(files)
    return EXIT_LOOK if turned else 0
