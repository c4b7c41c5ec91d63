"""Superconvergence of lengths, and what conjugate points do to them."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic import RBFCollocation, RBFRitz, Status, solve_geodesic
from bodymeasure.paper.analysis.forms import FLOOR, path_errors
from bodymeasure.paper.analysis.linear_model import fitted_order
from bodymeasure.paper.tables.beyond import ANY, Known
from bodymeasure.paper.tables.table import Column, Table

COUNTS = (4, 6, 8, 10, 12)
# Fewer errors give no slope.
FEWEST_POINTS = 10
# Lengths of arcs of a great circle, as parts of the distance pi of the conjugate point.
PARTS = (0.25, 0.4, 0.55, 0.7, 0.8, 0.84)
ARC_FUNCTIONS = 8
# The latitude of both ends; the arc between them runs nearer to the pole.
LATITUDE = 0.15


class _Slope(NamedTuple):
    form: str
    functions: int
    h1: float | None
    raw: float | None
    corrected: float | None


class _Fit(NamedTuple):
    form: str
    raw: float | None
    corrected: float | None


class _Arc(NamedTuple):
    part: float
    beta: float
    raw: float | None
    corrected: float | None
    status: str


def superconvergence_tables(known: Known, counts: Sequence[int] = COUNTS) -> tuple[Table, Table]:
    """Return the slopes of errors of lengths against errors of paths, and the medians behind them.

    The slopes are fitted over all patches and numbers of functions; 2 is expected of the length of
    the path, and more of the corrected one.
    """
    fits, medians = [], []
    for form in ("weak", "collocation"):
        every = []
        for count in counts:
            method = (
                RBFRitz(functions=count, tolerance=ANY)
                if form == "weak"
                else RBFCollocation(functions=count, tolerance=ANY, form="full")
            )
            found = path_errors(known, method)
            rows = found.solved & (found.h1 > 0.0)
            errors = np.abs(np.stack([found.h1, found.raw, found.corrected]))[:, rows]
            every.append(errors)
            middle = np.median(errors, axis=1).tolist() if rows.any() else [None] * 3
            medians.append(_Slope(form, count, *middle))
        h1, raw, corrected = np.concatenate(every, axis=1)
        slopes = []
        for errors in (raw, corrected):
            above = errors > FLOOR
            # A fall of the path's error by a factor is one of the length's by its power.
            fits_line = above.sum() >= FEWEST_POINTS
            slopes.append(-fitted_order(h1[above], errors[above]) if fits_line else None)
        fits.append(_Fit(form, *slopes))
    fitted = Table.of(
        "future_superconvergence",
        f"Superconvergence of the length, {len(known.length)} patches",
        (
            Column("form", "Form", "text"),
            Column("raw", "Order of the length's error in that of the path", "number"),
            Column("corrected", "of the corrected length's", "number"),
        ),
        fits,
        "Fitted over all patches and numbers of functions where errors are above rounding. The "
        "error of the path is that of its slopes in (u, v), in L2.",
    )
    shown = Table.of(
        "future_slopes",
        "Errors of paths and lengths, medians",
        (
            Column("form", "Form", "text"),
            Column("functions", "Functions", "count"),
            Column("h1", "Path", "small"),
            Column("raw", "Its length", "small"),
            Column("corrected", "Corrected length", "small"),
        ),
        medians,
    )
    return fitted, shown


class Sphere:
    """The unit sphere by longitude and latitude, about the equator, up to some longitude.

    Parameters
    ----------
    span : float
        The longitude at u = 1; v = 0 to 1 are latitudes from -1 to 1.
    """

    def __init__(self, span: float) -> None:
        self.span = span

    def derivatives(self, parameters: Array) -> Array:
        """Return all partial derivatives up to the third order, shape (..., 10, 3)."""
        longitude, latitude = self.span * parameters[..., 0], 2.0 * parameters[..., 1] - 1.0
        quarter = math.pi / 2.0
        rows = []
        for i, j in (
            (0, 0),
            (1, 0),
            (0, 1),
            (2, 0),
            (1, 1),
            (0, 2),
            (3, 0),
            (2, 1),
            (1, 2),
            (0, 3),
        ):
            along, up = self.span**i, 2.0**j
            cosine = up * np.cos(latitude + j * quarter)
            rows.append(
                np.stack(
                    [
                        along * np.cos(longitude + i * quarter) * cosine,
                        along * np.sin(longitude + i * quarter) * cosine,
                        (0.0 if i else 1.0) * up * np.sin(latitude + j * quarter),
                    ],
                    axis=-1,
                )
            )
        return np.stack(rows, axis=-2)


def conjugate_table(parts: Sequence[float] = PARTS) -> Table:
    """Return errors of arcs of great circles as their ends come near to conjugate points."""
    rows = []
    for part in parts:
        # Between points of one latitude, so that the path is no straight line in (u, v).
        cosine = math.cos(math.pi * part) - math.sin(LATITUDE) ** 2
        surface = Sphere(math.acos(cosine / math.cos(LATITUDE) ** 2))
        start, end = (0.0, (1.0 + LATITUDE) / 2.0), (1.0, (1.0 + LATITUDE) / 2.0)
        solution = solve_geodesic(
            surface,
            start,
            end,
            method=RBFCollocation(functions=ARC_FUNCTIONS, tolerance=ANY, form="full"),
            on_failure="status",
        )
        truth = math.pi * part
        found = solution.status is Status.CONVERGED
        rows.append(
            _Arc(
                part,
                1.0 - part**2,
                abs(float(solution.raw_length) / truth - 1.0) if found else None,
                abs(float(solution.length) / truth - 1.0) if found else None,
                getattr(solution.status, "name", "").lower().replace("_", " "),
            )
        )
    return Table.of(
        "future_conjugate",
        f"Arcs of a great circle, {ARC_FUNCTIONS} functions",
        (
            Column("part", "Length / pi", "number"),
            Column("beta", "beta", "number"),
            Column("raw", "Error of the path's length", "small"),
            Column("corrected", "of the corrected length", "small"),
            Column("status", "Status", "text"),
        ),
        rows,
        "On the unit sphere the end of an arc of length pi is conjugate to its start. beta is the "
        "inf-sup constant of the Jacobi form, 1 - (L / pi)^2; errors of paths grow as it falls.",
    )
