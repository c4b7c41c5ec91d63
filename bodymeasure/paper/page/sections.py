"""The text of the page and the summary, and the order in which they show the tables."""

from typing import NamedTuple

from bodymeasure.paper.data import published
from bodymeasure.paper.method.ritz_table import ERROR_BOUND, MAX_ORDER
from bodymeasure.paper.page.shown import shown
from bodymeasure.paper.reproduction import CHOSEN, Reproduction
from bodymeasure.paper.tables.statistics import key
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.table_5 import DIAGONALS, PAPERS_ROWS, TWO_FUNCTIONS
from bodymeasure.report import numbers

# The sections: anchor, heading, the beginnings of the names of their tables, and a text.
SECTIONS: tuple[tuple[str, str, tuple[str, ...], str], ...] = (
    (
        "bars",
        "What was to be reached",
        ("bars_",),
        "These are the aims of this reproduction, which were set beforehand. What missed them is "
        "shown, too.",
    ),
    (
        "readings",
        "Which testing data",
        ("closest", "events"),
        "Section 6.1 says how the 1000 patches were drawn, but not in every detail. Each reading "
        "below was drawn from the same seed, in four sets; patches that fold over or cut through "
        "themselves were refused.",
    ),
    (
        "samples",
        "Table 3: sample data",
        ("table_3_",),
        "Lengths and processor times by both methods, with the paper's rows at the right.",
    ),
    (
        "losses",
        "Table 4: radial functions against Ritz",
        ("table_4_",),
        "Table 1 takes the shortest of all solutions. Most solutions run far outside the patch, "
        "where the polynomial continues and the patch does not; so each reading has a second "
        "table, for the shortest solution that stays inside. Failures are counted, and none is "
        "left out of the number of patches.",
    ),
    (
        "truth",
        "Which of the two is in error",
        ("truth_",),
        "The paper compares its method with Ritz's, which has errors, too. Here both are compared "
        "with the shortest converged path of a thorough search.",
    ),
    (
        "table5",
        "Table 5: a body",
        ("table_5",),
        "The paper measured the virtual model of a real mannequin. Here that is the surface to "
        "which the atlas of a sample body was fitted. Lengths on it come from meshes of it, and "
        "share no code with the calculated ones.",
    ),
    ("speed", "Time a patch", ("speed",), "The time that the same accuracy takes."),
    (
        "scaling",
        "Distributed collocation",
        ("scaling",),
        "The paper's reference [8] divides the work between computers; here processes share it.",
    ),
    (
        "beyond",
        "Beyond 2007",
        ("beyond",),
        "The paper found three or more functions too slow. With Newton's method from the straight "
        "line, in place of a search for all solutions, they are not.",
    ),
    (
        "named",
        "The methods that the paper names",
        ("named_",),
        "The paper's introduction names methods on triangle meshes: straightest paths [4], "
        "subdivision and unfolding [5], straightest paths with normals [6], and fast marching [7]. "
        "Here they are beside exact paths, edge flips and the heat method.",
    ),
    (
        "future",
        "Future work of 2007",
        ("future_",),
        "The paper ends with what it leaves to others: “the theoretical analysis, and weak-form "
        "solutions”. Here are the weak form beside collocation, the orders at which both converge, "
        "why lengths are better than paths, and how much is proven. The pages “analysis” and "
        "“proofs” of the documentation have the arguments.",
    ),
)
# The choices that were made where the paper leaves them open.
CHOICES = (
    (
        "Which solution",
        "Table 1 takes the shortest of all. That one and the shortest inside the patch are shown.",
    ),
    (
        "All solutions",
        "With the end conditions eliminated, the equations at the one collocation point are two "
        "polynomials in two unknowns. A resultant, with either unknown hidden, finds all of their "
        "roots, and Newton's method refines them.",
    ),
    (
        "Other collocation points",
        "The first one is t = 0.5. Where the determinant of the equations is zero at the solution, "
        "or there is no solution, 0.45, 0.55, 0.4 and so on are tried.",
    ),
    (
        "Ritz's bound and limit",
        "The paper gives neither. The order grows until the length changes by less than "
        f"{numbers.scientific(ERROR_BOUND)}, up to order {MAX_ORDER}.",
    ),
    (
        "Equation (15)",
        "The printed equation has a sum but no number of samples. “Mean accuracy loss” is taken as "
        "the mean, over a set, of (15) for each sample; the root mean square stands beside it.",
    ),
    (
        "The physical lengths",
        "The paper says that they were measured on the virtual model of a mannequin, but not how. "
        "Here they are the shortest paths on the surface itself, between the points nearest to "
        "the corners of the patch.",
    ),
    ("Time", "It is the processor time of one patch by itself; the paper gives elapsed time."),
    ("The testing data", "They are described by the readings of section 6.1."),
)
SHARE = Column("share", "Share", "share")
# The most rows of a table that is not folded away behind its charts.
LONG = 30


class Section(NamedTuple):
    """A part of the page: the anchor of its links, its heading and text, and its tables."""

    anchor: str
    heading: str
    words: str
    tables: tuple[Table, ...]


def sections_of(found: Reproduction) -> tuple[Section, ...]:
    """Return the sections for which a run has tables."""
    made = (
        Section(anchor, heading, words, tuple(t for t in found.tables if t.name.startswith(starts)))
        for anchor, heading, starts, words in SECTIONS
    )
    return tuple(section for section in made if section.tables)


def tiles(found: Reproduction) -> list[tuple[str, str, str]]:
    """Return what a reader wants to know first: headings, figures and remarks."""
    nearest = found.table("closest").records[0]
    chosen = next(r for r in found.table("closest").records if r["reading"] == CHOSEN)
    truth = {row["method"]: row for row in found.table(chosen_name("truth_")).records}
    speed = {row["method"]: row for row in found.table(chosen_name("speed_")).records}
    ours = speed["bodymeasure, default"]
    body = {row["curves"]: row for row in found.table("table_5_spread").records}
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
            "Table 5, mean size of errors",
            shown(body[DIAGONALS]["mean_absolute"], SHARE),
            f"by two functions: {shown(body[TWO_FUNCTIONS]['mean_absolute'], SHARE)}; "
            f"paper: {shown(body[PAPERS_ROWS]['mean_absolute'], SHARE)}",
        ),
        (
            "A diagonal today",
            f"{1e6 * ours['seconds']:.0f} µs",
            f"{ours['than_paper']:.0f} times as fast as the paper's Ritz",
        ),
    ]


def chosen_name(prefix: str) -> str:
    """Return the name of the table with a prefix that is about the chosen reading."""
    return prefix + key(CHOSEN)
