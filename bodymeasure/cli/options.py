"""Arguments and options that several commands share."""

from __future__ import annotations

import os
from pathlib import Path

import click

from bodymeasure.atlas import Atlas, Severity, Unit, check_atlas
from bodymeasure.errors import InputError
from bodymeasure.formats import read_atlas
from bodymeasure.samples import load_sample, sample_names

DEFAULT_SAMPLE = "female_average"
# How many faults an error message tells in full.
TOLD = 3

atlas_argument = click.argument("atlas", metavar="ATLAS")
optional_atlas_argument = click.argument(
    "atlas", metavar="[ATLAS]", default=DEFAULT_SAMPLE, required=False
)
unit_option = click.option(
    "--unit",
    type=click.Choice([unit.value for unit in Unit]),
    default=Unit.CM.value,
    show_default=True,
    help="Unit of the lengths.",
)
despite_errors_option = click.option(
    "--despite-errors",
    is_flag=True,
    help="Measure an atlas in which the check finds errors; look at each status then.",
)
no_cross_check_option = click.option(
    "--no-cross-check", is_flag=True, help="Leave out the comparison with libigl."
)
processes_option = click.option(
    "--processes",
    type=click.IntRange(min=1),
    default=lambda: available_cores(),
    show_default="all cores",
    help="Worker processes of the comparison.",
)


def available_cores() -> int:
    """Cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def load_atlas(name: str) -> Atlas:
    """An atlas from a file, or a sample by its name if there is no such file.

    Raises
    ------
    InputError
        If it is neither, or not a valid atlas.
    """
    path = Path(name)
    if path.suffix or path.exists() or len(path.parts) != 1:
        return read_atlas(path)
    if name in sample_names():
        return load_sample(name)
    raise InputError(
        f"{name}: no such file, and no sample of that name; `bodymeasure samples` lists the samples"
    )


def load_sound_atlas(name: str, *, despite_errors: bool) -> Atlas:
    """As `load_atlas`, and refuse an atlas whose check finds errors, unless told otherwise.

    Raises
    ------
    InputError
        The errors found, by patch, and what to do.
    """
    atlas = load_atlas(name)
    if despite_errors:
        return atlas
    errors = [f.message for f in check_atlas(atlas) if f.severity == Severity.ERROR]
    if errors:
        more = f"\n  and {len(errors) - TOLD} more" if len(errors) > TOLD else ""
        listed = "".join(f"\n  {message}" for message in errors[:TOLD])
        raise InputError(
            f"{name}: the atlas has {len(errors)} error{'s' if len(errors) > 1 else ''}:{listed}"
            f"{more}\nRepair it (`bodymeasure check` lists all), or measure --despite-errors."
        )
    return atlas
