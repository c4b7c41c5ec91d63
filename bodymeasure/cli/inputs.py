"""Atlases that users name on the command line: files or samples."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from bodymeasure.atlas import Atlas, FindingKind, Severity, check_atlas
from bodymeasure.cli.console import print_note
from bodymeasure.cli.options import file_settings
from bodymeasure.errors import InputError, ReadWarning
from bodymeasure.formats import format_of, read_atlas
from bodymeasure.samples import sample_names, sample_path
from bodymeasure.wording import nearest

# The number of errors that a message lists; the others are counted.
LISTED = 3
# Similarity of names from which on one is taken for a misspelling of the other.
NEAR = 0.7


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
