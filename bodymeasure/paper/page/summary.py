"""A summary of the reproduction, as Markdown that a repository shows."""

from collections.abc import Iterator

from bodymeasure.paper.data.random_patches import READINGS
from bodymeasure.paper.page.sections import CHOICES, LONG, sections_of, tiles
from bodymeasure.paper.page.shown import shown
from bodymeasure.paper.reproduction import CHOSEN, Reproduction
from bodymeasure.paper.tables.statistics import key
from bodymeasure.paper.tables.table import Column, Table


def render_summary(found: Reproduction) -> bytes:
    """Return the tables of the page, except for those of other readings and long ones."""
    return ("\n".join(_lines(found)) + "\n").encode()


def _lines(found: Reproduction) -> Iterator[str]:
    settings = found.settings
    quick = " --quick" if settings.quick else ""
    yield "# Ng, Pong and Wong (2007), reproduced"
    yield ""
    yield (
        f"Made by `bodymeasure paper{quick} --seed {settings.seed} --processes "
        f"{settings.processes}`; every figure is from that run, and columns marked † are measured "
        "times. The page and the files that it writes beside this summary have all readings of "
        "the testing data, charts, and every value in full precision."
    )
    yield ""
    for heading, figure, remark in tiles(found):
        yield f"- {heading}: **{figure}** ({remark})"
    for section in sections_of(found):
        tables = [table for table in section.tables if _is_shown(table)]
        yield from ("", f"## {section.heading}", "", section.words)
        for number, table in enumerate(tables):
            yield from ("", f"**{table.title}**", "")
            yield from _grid(table)
            # Tables of one kind share their notes.
            if table.notes and table.notes not in [t.notes for t in tables[number + 1 :]]:
                yield from ("", *"\n\n".join(table.notes).split("\n"))
    yield from ("", "## What was chosen where the paper leaves room", "")
    for what, chosen in CHOICES:
        yield f"- {what}: {chosen}"
    yield from ("", "## How it was computed", "")
    facts = {
        "seed": str(settings.seed),
        "patches a set": str(settings.group_size),
        "worker processes": str(settings.processes),
        **found.versions,
        **{f"time for {part}": f"{seconds:.0f} s" for part, seconds in found.seconds.items()},
    }
    for name, value in facts.items():
        yield f"- {name}: {value}"


def _is_shown(table: Table) -> bool:
    other = (key(reading.name) for reading in READINGS if reading.name != CHOSEN)
    return len(table.rows) <= LONG and not any(name in table.name for name in other)


def _grid(table: Table) -> Iterator[str]:
    yield _row([_heading(column) for column in table.columns])
    yield _row(["---" if column.kind == "text" else "---:" for column in table.columns])
    for row in table.rows:
        yield _row([shown(*each) for each in zip(row, table.columns, strict=True)])


def _heading(column: Column) -> str:
    return f"{column.label} †" if column.is_timing else column.label


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"
