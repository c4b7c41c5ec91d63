"""A survey as it is run: what is not done yet, by an engine, and then the table."""

import itertools
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec

from bodymeasure.errors import InputError
from bodymeasure.measure import package_versions
from bodymeasure.surveys.bodies import Bodies
from bodymeasure.surveys.engine import Batch, Engine, Work, batch_size
from bodymeasure.surveys.folder import Parts, agree_on_settings, locked
from bodymeasure.surveys.records import (
    Charting,
    Row,
    SurveyTable,
    read_survey,
    require_pyarrow,
    write_table,
)
from bodymeasure.surveys.records.table import TABLE, Head

# The table while it is written.
UNFINISHED = ".survey.parquet.unfinished"


def run_survey(
    bodies: Bodies,
    charting: Charting,
    folder: Path,
    engine: Engine,
    *,
    progress: Callable[[int, int], None] | None = None,
) -> SurveyTable:
    """Measure all bodies into a folder, or what is not yet done of them.

    Parameters
    ----------
    bodies : Bodies
    charting : Charting
    folder : Path
        It is there.
    engine : Engine
    progress : callable, optional
        Called with the number of bodies done, and of all.

    Raises
    ------
    InputError
        If the folder holds a survey with other settings, or another process is at work in it.
    """
    require_pyarrow()
    if not charting.columns:
        name = charting.definitions.name
        raise InputError(f"the set {name!r} defines no measurement; add one to it")
    with locked(folder):
        versions = package_versions()
        agree_on_settings(
            folder,
            {
                "bodies": bodies.identity(),
                "definitions": msgspec.to_builtins(charting.definitions),
                "only": list(charting.only),
                "unit": charting.unit.value,
                "despite_errors": charting.despite_errors,
                "versions": versions,
            },
        )
        table, count = folder / TABLE, len(bodies)
        size = batch_size(count)
        starts = range(0, count, size)
        parts = Parts(folder, len(starts))
        if not table.exists():
            sizes = [min(size, count - start) for start in starts]
            parts.require_whole(sizes)
            _measure(bodies, charting, parts, engine, progress)
            head = Head(
                unit=charting.unit.value,
                definitions=charting.definitions.name,
                only=list(charting.only),
                bodies=count,
                versions=versions,
                measurements=list(charting.columns),
            )
            _write(table, head, parts)
        elif progress is not None:
            progress(count, count)
        parts.remove()
    return read_survey(table)


def _write(table: Path, head: Head, parts: Parts) -> None:
    """Write the table whole or not at all."""
    unfinished = table.with_name(UNFINISHED)
    try:
        write_table(unfinished, head, parts)
        unfinished.replace(table)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise InputError(
            f"{table}: cannot be written ({error.strerror or error}); make room on the disk, and "
            "give the same call again: all that was measured is kept"
        ) from None


def _measure(
    bodies: Bodies,
    charting: Charting,
    parts: Parts,
    engine: Engine,
    progress: Callable[[int, int], None] | None,
) -> None:
    """Measure what is not yet done, and write each part when it is whole."""
    count, size = len(bodies), batch_size(len(bodies))
    missing = [number for number in range(parts.count) if number not in parts.done]

    def batches() -> Iterator[Batch]:
        for number in missing:
            start = number * size
            yield Batch(number, 0, tuple(bodies.between(start, min(start + size, count))))

    done = count - sum(min(size, count - number * size) for number in missing)
    if progress is not None:
        progress(done, count)
    if not missing:
        return
    pieces: dict[int, dict[int, Row]] = {}
    for answer in engine(batches(), Work.of(charting)):
        number = answer.batch.number
        rows = pieces.setdefault(number, {})
        rows |= dict(zip(itertools.count(answer.batch.first), answer.rows, strict=False))
        if len(rows) == min(size, count - number * size):
            parts.write(number, [rows[place] for place in sorted(rows)])
            done += len(rows)
            del pieces[number]
            if progress is not None:
                progress(done, count)
