"""`bodymeasure sizes`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_files, print_note, print_table
from bodymeasure.cli.needs import require
from bodymeasure.cli.options import NumberRange, folder_option
from bodymeasure.cli.surveys.made import made_bodies
from bodymeasure.cli.surveys.progress import long_progress
from bodymeasure.cli.surveys.size import pairs
from bodymeasure.cli.tables import new_table
from bodymeasure.files import output_folder
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.surveys import SizeTable

TABLE = ("a survey", "pyarrow", "pyarrow", "survey")
PAGE = ("the page of sizes", "jinja2", "jinja2", "survey")
MEDOIDS = ("sizes by medoids", "kmedoids", "kmedoids", "survey")


@click.command(epilog=EXIT_CODES)
@click.argument("survey", metavar="SURVEY", type=click.Path(path_type=Path))
@click.option(
    "--by",
    "steps",
    metavar="KEY=STEP,...",
    required=True,
    callback=lambda _ctx, _parameter, value: pairs(value),
    help="The key measurements, each with the difference of neighboring sizes, such as "
    "stature=8,bust_girth=4, in the survey's unit. A size fits half of it to both sides.",
)
@folder_option(
    help="Folder for sizes.html, sizes.csv, controls.csv and the mannequins; made if it is not "
    "there. Without it, the sizes are printed.",
)
@click.option(
    "--medoids",
    type=click.IntRange(min=1),
    metavar="N",
    help="Make N sizes that lie where the bodies are, by k-medoids, in place of sizes at multiples "
    "of the steps.",
)
@click.option(
    "--least",
    type=NumberRange(0.0, 1.0),
    metavar="PART",
    help="The least part of the bodies for which there is a size at a multiple of the steps.  "
    "[default: 0.01]",
)
@click.option(
    "--most",
    type=click.IntRange(min=1),
    metavar="N",
    help="The most sizes at multiples of the steps; those of the most bodies are kept.",
)
@click.option(
    "--make",
    "made",
    is_flag=True,
    help="Make a body for each size besides, with its key measurements and the means of others; "
    "some seconds each.",
)
def sizes(
    survey: Path,
    steps: dict[str, float],
    output: Path | None,
    medoids: int | None,
    least: float | None,
    most: int | None,
    made: bool,
) -> int:
    """Make a table of sizes from a SURVEY: survey.parquet, or its folder.

    Sizes lie at multiples of the steps of the key measurements, and those are kept that enough
    bodies have; or, with --medoids, where they are near to the most bodies. The table has what part
    of the bodies each fits, and all together; the means of the other measurements; and the surveyed
    body that is nearest to each size, whose atlas is its mannequin.
    """
    if medoids is not None and (least is not None or most is not None):
        raise click.UsageError("--least and --most are for sizes at multiples of the steps.")
    if made and output is None:
        raise click.UsageError("--make writes bodies; give a folder for them with -o.")
    needs = [TABLE, *((PAGE,) if output is not None else ())]
    require(*needs, *((MEDOIDS,) if medoids is not None else ()))
    # Slow imports, which `--help` does not need.
    from bodymeasure.surveys import MedoidSizes, StepSizes, read_survey, size_table, write_sizes
    from bodymeasure.surveys.sizes.schemes import LEAST

    scheme = (
        StepSizes(steps, LEAST if least is None else least, most)
        if medoids is None
        else MedoidSizes(steps, medoids)
    )
    table = size_table(read_survey(survey), scheme)
    files: tuple[Path, ...] = ()
    if output is not None:
        with output_folder(output), long_progress("making bodies") as progress:
            bodies = made_bodies(table, progress) if made else None
            files = write_sizes(table, output, made=bodies)
    print_table(_sizes(table))
    bodies_counted = counted(table.bodies, "body", "bodies")
    RESULTS.print(Text(f"\nThey fit {table.coverage:.1%} of {bodies_counted}."))
    print_files([file for file in files if file.suffix != ".atlas"])
    stems = [file.stem for file in files if file.suffix == ".atlas"]
    unmade = len(table.sizes) - sum(stem.endswith("-made") for stem in stems)
    missing = len(table.sizes) - sum(not stem.endswith("-made") for stem in stems)
    if made and unmade:
        print_note(
            f"{unmade} of {len(table.sizes)} bodies could not be made; sizes.csv has the reasons."
        )
    if files and missing:
        print_note(
            f"{missing} of {len(table.sizes)} mannequins are not written, since their bodies are "
            "not where the survey found them."
        )
    return 0


def _sizes(table: "SizeTable") -> "Table":
    from bodymeasure.report.body import tape_text

    headings = [f"{column.name}, {column.unit}" for column in table.keys]
    shown = new_table(
        "size", *headings, "bodies", "part", "together", "nearest body", words=("nearest body",)
    )
    for size in table.sizes:
        shown.add_row(
            size.name,
            *(tape_text(size.center[column.key], column.unit) for column in table.keys),
            f"{size.bodies:,}",
            f"{size.part:.1%}",
            f"{size.together:.1%}",
            Text(table.survey.subjects[size.mannequin]),
        )
    return shown
