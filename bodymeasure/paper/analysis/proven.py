"""How much of a body is proven: shortest paths, and bounds of their lengths."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure.geodesic import RBFCollocation
from bodymeasure.measure import diagonals
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.samples import load_sample

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
FUNCTIONS = 20


class _Body(NamedTuple):
    body: str
    diagonals: int
    proven: int
    width: float
    wide: float
    outside: int


def proven_table(bodies: Sequence[str] = BODIES) -> Table:
    """Return how many diagonals of bodies are proven shortest, and how close their bounds are."""
    rows = []
    for name in bodies:
        body = load_sample(name)
        proven = diagonals(body, on_failure="status").proven_shortest
        finer = diagonals(body, method=RBFCollocation(functions=FUNCTIONS), on_failure="status")
        (lower, upper), known = finer.bounds, finer.converged
        width = ((upper - lower) / upper)[finer.proven_shortest]
        outside = ((finer.length < lower) | (finer.length > upper))[known]
        rows.append(
            _Body(
                name,
                proven.size,
                int(proven.sum()),
                float(np.median(width)),
                float(np.quantile(width, 0.95)),
                int(outside.sum()),
            )
        )
    return Table.of(
        "future_proofs",
        "Diagonals of the sample bodies",
        (
            Column("body", "Body", "text"),
            Column("diagonals", "Diagonals", "count"),
            Column("proven", "Proven shortest", "count"),
            Column("width", f"Width of the bounds, {FUNCTIONS} functions: median", "small"),
            Column("wide", "95 %", "small"),
            Column("outside", "Lengths outside", "count"),
        ),
        rows,
        "A diagonal is proven to be the only shortest path on its patch by a bound of the patch's "
        "curvature. The bounds of its length hold by theorem; their widths are relative, of the "
        "diagonals that are proven. The page “proofs” of the documentation has the argument.",
    )
