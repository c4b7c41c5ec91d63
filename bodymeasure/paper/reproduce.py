"""The whole reproduction: every table of the paper and those beyond it, from one seed."""

import time
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field

import numpy as np

from bodymeasure.bench.entrants.entrants import POINTS_A_SIDE
from bodymeasure.measure import package_versions
from bodymeasure.paper.analysis.forms import COUNTS as FORM_COUNTS
from bodymeasure.paper.analysis.forms import forms_table, quadrature_table
from bodymeasure.paper.analysis.orders import model_errors_table, orders_table
from bodymeasure.paper.analysis.proven import BODIES, proven_table
from bodymeasure.paper.analysis.statements import conjugate_table, superconvergence_tables
from bodymeasure.paper.data.comparison import compare, in_chunks
from bodymeasure.paper.data.random_patches import (
    GROUPS,
    READINGS,
    RandomPatches,
    Reading,
    make_testing_data,
)
from bodymeasure.paper.method.normalization import normalize
from bodymeasure.paper.reproduction import BODY, CHOSEN, Reproduction, Settings
from bodymeasure.paper.surface.table5 import table5
from bodymeasure.paper.tables.aims import accuracy_bars, speed_bars
from bodymeasure.paper.tables.beyond import (
    COUNTS,
    FEW_COUNTS,
    Known,
    beyond_table,
    families,
    known_diagonals,
)
from bodymeasure.paper.tables.medians import medians_table
from bodymeasure.paper.tables.named_methods import named_methods_table
from bodymeasure.paper.tables.readings import closest_table, events_table
from bodymeasure.paper.tables.scaling import measure_scaling, scaling_table
from bodymeasure.paper.tables.speed import BATCH, speed_table
from bodymeasure.paper.tables.spreads import distribution_table, roots_table
from bodymeasure.paper.tables.statistics import key
from bodymeasure.paper.tables.table import Table
from bodymeasure.paper.tables.table_5 import (
    body_distribution,
    by_two_functions,
    curve_tables,
    spread_of_table_5,
    table_5,
)
from bodymeasure.paper.tables.tables_3_and_4 import (
    ReadingResult,
    table_3,
    table_4,
    truth_table,
)
from bodymeasure.samples import load_sample
from bodymeasure.threads import one_blas_thread

BODY_PATCHES = Reading(f"body {BODY}", "Patches of a sample body, normalized.", 1.0)
# A quick run measures so many of the body's diagonals and boundary curves on its surface.
QUICK_CURVES = 12
# Numbers of patches of the chosen reading for its future work.
FUTURE_PATCHES, QUICK_FUTURE_PATCHES = 100, 20
# Numbers of patches of the chosen reading for what lies beyond the paper, and for the scaling.
BEYOND_PATCHES, QUICK_BEYOND_PATCHES = 200, 20
SCALING_PATCHES, QUICK_SCALING_PATCHES = 600, 40
# Numbers of diagonals for the methods on meshes.
NAMED_DIAGONALS, QUICK_NAMED_DIAGONALS = 12, 2
PACKAGES = ("bodymeasure", "numpy", "scipy", "libigl", "matplotlib", "potpourri3d", "pygeodesic")

FEW_FORM_COUNTS = (4, 8)

# Opens a progress bar with a label and a total, which is called with how many are done.
Bar = Callable[[str, int], AbstractContextManager[Callable[[int], None]]]


def no_bar(_label: str, _total: int) -> AbstractContextManager[Callable[[int], None]]:
    """Open a progress bar that nobody sees."""
    return nullcontext(lambda _done: None)


@dataclass
class _Study:
    """The tables and results that the parts of a run pass on."""

    settings: Settings
    bar: Bar
    tables: list[Table] = field(default_factory=list)
    results: list[ReadingResult] = field(default_factory=list)
    body: ReadingResult = field(init=False)

    @property
    def chosen(self) -> ReadingResult:
        return next(r for r in self.results if r.reading.name == CHOSEN)


@one_blas_thread()
def reproduce(settings: Settings, bar: Bar = no_bar) -> Reproduction:
    """Run everything, and return all tables.

    Parameters
    ----------
    settings : Settings
    bar : callable, optional
        Opens a progress bar.
    """
    study = _Study(settings, bar)
    seconds = {}
    for name, part in PARTS:
        begin = time.perf_counter()
        part(study)
        seconds[name] = time.perf_counter() - begin
    return Reproduction(settings, tuple(study.tables), package_versions(PACKAGES), seconds)


def _testing(study: _Study) -> None:
    """Tables 3 and 4 for each reading."""
    seed, size = study.settings.seed, study.settings.group_size
    drawn = []
    with study.bar("drawing patches", len(READINGS)) as progress:
        for number, reading in enumerate(READINGS, start=1):
            drawn.append(make_testing_data(reading, seed, groups=GROUPS, size=size))
            progress(number)
    body = load_sample(BODY).control_points[:: study.settings.body_step]
    drawn.append(RandomPatches(normalize(body).control_points[None], 0, 0))
    # All of them together, so that processes are started only once.
    nets = np.concatenate([data.control_points.reshape(-1, 4, 4, 3) for data in drawn])
    with study.bar("Tables 3 and 4", len(nets)) as progress:
        found = compare(nets, processes=study.settings.processes, progress=progress)
    first = 0
    for reading, data in zip((*READINGS, BODY_PATCHES), drawn, strict=True):
        last = first + data.control_points[..., 0, 0, 0].size
        result = ReadingResult(reading, data, found.take(slice(first, last)))
        first = last
        if reading is BODY_PATCHES:
            study.body = result
        else:
            study.results.append(result)
    study.tables.append(closest_table(study.results))
    for result in study.results:
        study.tables += [
            table_3(result),
            table_4(result, "inside"),
            table_4(result, "all"),
            truth_table(result),
        ]
    study.tables += [
        truth_table(study.body),
        events_table(study.results),
        distribution_table(study.results),
        roots_table(study.results),
    ]


def _body(study: _Study) -> None:
    """Table 5, and whether the accuracies found so far reach the aims."""
    settings = study.settings
    atlas = load_sample(BODY)
    rows = QUICK_CURVES if settings.quick else None
    with study.bar("Table 5", rows or 2 * len(atlas)) as progress:
        found = table5(
            BODY, rows=rows, seed=settings.seed, processes=settings.processes, progress=progress
        )
    parts = len(in_chunks(found.diagonals.calculated))
    with study.bar("Table 5 by two functions", parts) as progress:
        two = by_two_functions(found.diagonals, atlas, settings.processes, progress)
    study.tables += [
        table_5(found, two),
        spread_of_table_5(found, two),
        body_distribution(BODY, found, two),
        *curve_tables(found, two),
        accuracy_bars(study.chosen, found.distributions()[0].mean_absolute),
    ]


def _speed(study: _Study) -> None:
    """Times a patch."""
    tables = []
    results = [*study.results, study.body]
    with study.bar("time a patch", len(results)) as progress:
        for number, result in enumerate(results, start=1):
            batch = len(result.found) if study.settings.quick else BATCH
            tables.append(speed_table(f"speed_{key(result.reading.name)}", result, batch))
            progress(number)
    study.tables += [*tables, speed_bars(tables)]


def _scaling(study: _Study) -> None:
    """Distributed collocation."""
    count = QUICK_SCALING_PATCHES if study.settings.quick else SCALING_PATCHES
    nets = study.chosen.data.control_points.reshape(-1, 4, 4, 3)
    nets = np.tile(nets, (-(-count // len(nets)), 1, 1, 1))[:count]
    numbers = sorted({1, 2, study.settings.processes})
    with study.bar("distributed collocation", len(numbers)) as progress:
        runs = measure_scaling(nets, numbers, progress, with_start=not study.settings.quick)
        study.tables.append(scaling_table(runs))


def _beyond(study: _Study) -> None:
    """More functions, other kernels and other centers."""
    quick = study.settings.quick
    nets = study.chosen.data.control_points.reshape(-1, 4, 4, 3)
    nets = nets[: QUICK_BEYOND_PATCHES if quick else BEYOND_PATCHES]
    problems = [
        known_diagonals(f"random, {CHOSEN}", nets),
        known_diagonals(BODY_PATCHES.name, study.body.data.control_points[0]),
    ]
    counts: Sequence[int] = FEW_COUNTS if quick else COUNTS
    with study.bar("beyond 2007", len(families())) as progress:
        table = beyond_table(problems, counts, progress)
    study.tables += [medians_table(table), table]


def _named(study: _Study) -> None:
    """The methods on meshes that the paper's introduction names."""
    quick = study.settings.quick
    count = QUICK_NAMED_DIAGONALS if quick else NAMED_DIAGONALS
    nets = study.chosen.data.control_points.reshape(-1, 4, 4, 3)
    problems = [
        _first(known_diagonals(f"random, {CHOSEN}", nets[: 2 * count]), count),
        _first(known_diagonals(BODY_PATCHES.name, study.body.data.control_points[0]), count),
    ]
    points = POINTS_A_SIDE[:2] if quick else POINTS_A_SIDE
    with study.bar("the methods that the paper names", len(problems)) as progress:
        study.tables.append(named_methods_table(problems, points, progress))


def _first(known: Known, count: int) -> Known:
    return Known(known.name, known.control_points[:count], known.length[:count])


def _future(study: _Study) -> None:
    """The weak form, orders, proofs and bounds."""
    quick = study.settings.quick
    nets = study.chosen.data.control_points.reshape(-1, 4, 4, 3)
    known = known_diagonals(CHOSEN, nets[: QUICK_FUTURE_PATCHES if quick else FUTURE_PATCHES])
    with study.bar("future work of 2007", 6) as progress:
        study.tables.append(forms_table(known, FEW_FORM_COUNTS if quick else FORM_COUNTS))
        progress(1)
        study.tables += [orders_table(), model_errors_table()]
        progress(2)
        study.tables += superconvergence_tables(known)
        progress(3)
        study.tables.append(quadrature_table(known))
        progress(4)
        study.tables.append(conjugate_table())
        progress(5)
        study.tables.append(proven_table(BODIES[:1] if quick else BODIES))
        progress(6)


PARTS: tuple[tuple[str, Callable[[_Study], None]], ...] = (
    ("Tables 3 and 4", _testing),
    ("Table 5", _body),
    ("speed", _speed),
    ("distributed collocation", _scaling),
    ("beyond 2007", _beyond),
    ("the methods that the paper names", _named),
    ("future work of 2007", _future),
)
