"""The reproduction as one self-contained page."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

from bodymeasure.errors import MissingExtraError
from bodymeasure.paper import charts, published
from bodymeasure.paper.reproduce import BODY, CHOSEN, Reproduction
from bodymeasure.paper.table import Column, Value
from bodymeasure.report import numbers
from bodymeasure.report.html import data_uri

# Tables of each section by the beginnings of their names, and what the page says of them.
SECTIONS: tuple[tuple[str, str, tuple[str, ...], str], ...] = (
    (
        "bars",
        "What was to be reached",
        ("bars_",),
        "The aims of this reproduction, set beforehand; what missed them is here too.",
    ),
    (
        "readings",
        "Which testing data",
        ("closest", "events"),
        "Section 6.1 says how the 1000 patches were drawn, but leaves room. Each reading below was "
        "drawn from the same seed, in four sets; patches that fold over or cut through themselves "
        "were refused.",
    ),
    (
        "samples",
        "Table 3: sample data",
        ("table_3_",),
        "Lengths and processor time by both methods, with the paper's rows at the right.",
    ),
    (
        "losses",
        "Table 4: radial functions against Ritz",
        ("table_4_",),
        "Table 1 takes the shortest of all solutions. Most solutions run far outside the patch, "
        "where the polynomial goes on and the patch does not; so each reading has a second table, "
        "of the shortest solution that stays inside. Failures are counted, and none is dropped "
        "from the count of patches.",
    ),
    (
        "truth",
        "Which of the two erred",
        ("truth_",),
        "The paper compares its method with Ritz's, which errs too. Here both stand against the "
        "converged shortest path.",
    ),
    (
        "table5",
        "Table 5: a body",
        ("table_5",),
        "The paper measured the virtual model of a real mannequin. Here that is the surface that a "
        "sample body's atlas was fitted to; its lengths come from meshes of it, and share no code "
        "with the calculated ones.",
    ),
    ("speed", "Time a patch", ("speed",), "What the same accuracy costs."),
    (
        "scaling",
        "Distributed collocation",
        ("scaling",),
        "The paper's reference [8] splits the work over computers; here over processes.",
    ),
    (
        "beyond",
        "Beyond 2007",
        ("beyond",),
        "The paper found three or more functions too slow to run. With Newton's method from the "
        "straight line, instead of all solutions, they are not.",
    ),
)
# Shown as charts alone; the files have their numbers.
CHARTED = ("distribution", "roots")
# Rows from which a table is folded away behind its charts.
LONG = 30


def render_page(found: Reproduction) -> bytes:
    """A reproduction as one HTML page that loads nothing else.

    Raises
    ------
    MissingExtraError
        If jinja2 or matplotlib is not installed.
    """
    try:
        import jinja2
    except ImportError:
        raise MissingExtraError("the HTML page", "jinja2", "report") from None
    own = files("bodymeasure.paper").joinpath("templates", "paper.html.j2")
    css = files("bodymeasure.report").joinpath("templates", "report.css").read_text("utf-8")
    environment = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["shown"] = shown
    template = environment.from_string(own.read_text("utf-8"))
    return template.render(**_context(found), css=css).encode()


def _context(found: Reproduction) -> dict[str, Any]:
    sections, made = [], _pictures(found)
    for anchor, heading, prefixes, words in SECTIONS:
        tables = [t for t in found.tables if t.name.startswith(prefixes)]
        if tables:
            sections.append((anchor, heading, words, made.get(anchor, []), tables))
    return {
        "found": found,
        "sections": sections,
        "tiles": _tiles(found),
        "long": LONG,
        "published": published,
    }


def _pictures(found: Reproduction) -> dict[str, list[tuple[str, str]]]:
    """Charts by section, each with its caption."""
    beyond = found.table("beyond")
    made = {
        "readings": [
            (
                charts.roots_chart(found.table("roots"), "roots"),
                "How many patches have how many real solutions, by reading; at t = 1/2.",
            )
        ],
        "truth": [
            (
                charts.distribution_chart(found.table("distribution"), CHOSEN, "distribution"),
                f"Reading “{CHOSEN}”: how large the differences are. Where the line of radial "
                "functions against Ritz lies on that against the truth, the accuracy loss is that "
                "of the two functions.",
            )
        ],
        "table5": [
            (
                charts.distribution_chart(found.table("body_distribution"), BODY, "body"),
                "How large the relative errors (17) are, of all curves.",
            )
        ],
        "beyond": [
            (
                charts.accuracy_chart(beyond, charts.METHODS, "methods"),
                "Error of the length of the computed path, without the correction.",
            ),
            (
                charts.accuracy_chart(beyond, charts.PLACINGS, "placings"),
                "The same for the paper's kernel, by where centers and collocation points stand.",
            ),
            (
                charts.cost_chart(beyond, charts.METHODS, "cost"),
                "Error with the correction against processor time, one point a number of "
                "functions.",
            ),
        ],
    }
    return {
        anchor: [(data_uri(svg), caption) for svg, caption in pictures]
        for anchor, pictures in made.items()
    }


def _tiles(found: Reproduction) -> list[tuple[str, str, str]]:
    """Heading, figure and remark of what a reader wants to know first."""
    nearest = found.table("closest").records[0]
    chosen = next(r for r in found.table("closest").records if r["reading"] == CHOSEN)
    truth = {row["method"]: row for row in found.table(_of_chosen("truth_")).records}
    speed = {row["method"]: row for row in found.table(_of_chosen("speed_")).records}
    ours = speed["bodymeasure, default"]
    return [
        ("Mean accuracy loss, paper", numbers.percent(published.MEAN_LOSS), "mean of four sets"),
        (
            f"Here, reading “{CHOSEN}”",
            numbers.percent(chosen["mean_loss_inside"]),
            f"nearest: “{nearest['reading']}”, {numbers.percent(nearest['mean_loss_inside'])}",
        ),
        (
            "Radial functions off the truth",
            numbers.scientific(truth["RBF, inside"]["median_size"]),
            f"median; Ritz: {numbers.scientific(truth['Ritz']['median_size'])}",
        ),
        (
            "A diagonal today",
            f"{1e6 * ours['seconds']:.0f} µs",
            f"{ours['than_paper']:.0f} times as fast as the paper's Ritz",
        ),
    ]


def _of_chosen(prefix: str) -> str:
    return prefix + CHOSEN.replace(" ", "_").replace(".", "_")


def shown(value: Value, column: Column) -> str:
    """A value as the page shows it; a dash for none."""
    if value is None:
        return numbers.NONE
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    match column.kind:
        case "count":
            return f"{value:,}"
        case "number":
            return f"{value:,}" if isinstance(value, int) else f"{value:,.2f}"
        case "length":
            return f"{value:#.6g}"
        case "percent":
            return numbers.percent(value)
        case "fine":
            return numbers.percent(value, 3)
        case "share":
            return f"{100.0 * value:.1f}\N{NO-BREAK SPACE}%"
        case "small":
            return numbers.scientific(value)
        case "seconds":
            return f"{value:.3f}"
        case "factor":
            return f"{value:,.2f}" if value < 10 else f"{value:,.0f}"
        case "text":
            return str(value)
